#include "watch.hpp"

#include <chrono>
#include <utility>

namespace discmc::python {

bool Watch::post(const MeshProgress& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_ = now;
  if (!options_.progress.is_none()) changed_.notify_one();
  return !is_cancelled_;
}

void Watch::look() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  std::optional<MeshProgress> now;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    now = std::exchange(latest_, std::nullopt);
  }
  if (!now || options_.progress.is_none()) return;
  if (options_.progress(now->step, now->done, now->all).is(py::bool_(false))) throw Cancelled();
}

void Watch::watch() {
  constexpr std::chrono::milliseconds between_looks{50};  // as fast as Ctrl-C is to be
  const bool is_called = !options_.progress.is_none();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!has_ended_) {
    changed_.wait_for(lock, between_looks,
                      [&] { return has_ended_ || (is_called && latest_ && !is_cancelled_); });
    if (has_ended_ || is_cancelled_) continue;
    lock.unlock();
    try {
      const py::gil_scoped_acquire interpreter;
      look();
    } catch (...) {
      failure_ = std::current_exception();
      is_cancelled_ = true;
    }
    lock.lock();
  }
}

}  // namespace discmc::python
