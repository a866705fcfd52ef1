// A call of the library that the interpreter watches.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include <discmc/mesh.hpp>

#include <pybind11/pybind11.h>

#include "options.hpp"

namespace discmc::python {

/// Runs the library in a thread of its own. The calling thread, which alone receives signals in
/// Python, looks for Ctrl-C and calls the user's progress at any time. Neither thread holds the
/// interpreter in between.
class Watch {
 public:
  explicit Watch(const Options& options) : options_(options) {}
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// For the call. Limit: the watch exists as long as they are used.
  MeshOptions options() {
    MeshOptions all = options_.mesh;
    all.progress = [this](const MeshProgress& now) { return post(now); };
    return all;
  }

  /// Returns work(), or throws what it throws, or the exception of a signal or of the user's
  /// progress; Cancelled if that returned False.
  template <class Work>
  auto run(Work work) {
    std::optional<decltype(work())> result;
    std::exception_ptr error;
    has_ended_ = false;
    {
      const py::gil_scoped_release others_run;
      std::thread worker([&] {
        try {
          result.emplace(work());
        } catch (...) {
          error = std::current_exception();
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        has_ended_ = true;
        changed_.notify_one();
      });
      watch();
      worker.join();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (error) std::rethrow_exception(error);
    look();
    return std::move(*result);
  }

  /// Looks for signals, and reports progress. Throws as run(). Limit: holds the interpreter.
  void look();

 private:
  bool post(const MeshProgress& now);
  void watch();

  Options options_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<MeshProgress> latest_;  // not yet reported
  bool has_ended_ = false;
  std::atomic<bool> is_cancelled_{false};
  std::exception_ptr failure_;
};

}  // namespace discmc::python
