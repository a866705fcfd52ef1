// Processes items in parallel, between two sequential steps.
#ifndef DISCMC_MESH_JOBS_ORDERED_PIPELINE_HPP
#define DISCMC_MESH_JOBS_ORDERED_PIPELINE_HPP

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace discmc::meshing {

/// Passes items 0 to count - 1 through three steps. fill(number, item) and consume(number, item)
/// are called in order, by one thread at a time. `jobs` threads call work(number, item). Items are
/// reused to keep their memory: there are twice as many as jobs, or as items if these are fewer. An
/// exception of a step ends the pipeline and is rethrown. One job starts no thread.
template <class Item, class Fill, class Work, class Consume>
class OrderedPipeline {
 public:
  /// Limit: at least one job.
  OrderedPipeline(unsigned jobs, std::size_t count, Fill fill, Work work, Consume consume)
      : jobs_(jobs),
        count_(count),
        slots_(2 * std::clamp<std::size_t>(count, 1, jobs)),
        fill_(fill),
        work_(work),
        consume_(consume) {}

  void run() {
    std::vector<std::thread> threads;
    try {
      for (unsigned i = 1; i < jobs_ && i < count_; ++i)
        threads.emplace_back([this] { run_steps(); });
    } catch (const std::system_error&) {
      // If the system refuses further threads, the existing ones do all work.
    }
    run_steps();
    for (std::thread& thread : threads) thread.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  enum class State { empty, filled, done };
  struct Slot {
    State state = State::empty;
    Item item{};
  };

  Slot& slot(std::size_t number) { return slots_[number % slots_.size()]; }

  // Runs until nothing is left to do.
  void run_steps() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!error_ && consumed_ < count_)
      if (!run_step(lock)) changed_.wait(lock);
    changed_.notify_all();
  }

  // Returns whether there was a step to run. Prefers steps that others wait for.
  bool run_step(std::unique_lock<std::mutex>& lock) {
    if (!is_consuming_ && slot(consumed_).state == State::done) {
      is_consuming_ = true;
      call(lock, consume_, consumed_);
      slot(consumed_++).state = State::empty;
      is_consuming_ = false;
    } else if (!is_filling_ && filled_ < count_ && slot(filled_).state == State::empty &&
               filled_ < begun_ + jobs_) {
      is_filling_ = true;
      call(lock, fill_, filled_);
      slot(filled_++).state = State::filled;
      is_filling_ = false;
    } else if (begun_ < filled_) {
      const std::size_t number = begun_++;
      call(lock, work_, number);
      slot(number).state = State::done;
    } else {
      return false;
    }
    changed_.notify_all();
    return true;
  }

  // Calls a step with the mutex unlocked.
  template <class Step>
  void call(std::unique_lock<std::mutex>& lock, Step& step, std::size_t number) {
    Item& item = slot(number).item;
    lock.unlock();
    std::exception_ptr error;
    try {
      step(number, item);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error && !error_) error_ = error;
  }

  const unsigned jobs_;
  const std::size_t count_;
  std::vector<Slot> slots_;
  Fill fill_;
  Work work_;
  Consume consume_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Numbers of items that were filled, begun and consumed.
  std::size_t filled_ = 0, begun_ = 0, consumed_ = 0;
  bool is_filling_ = false, is_consuming_ = false;
  std::exception_ptr error_;
};

/// Runs an OrderedPipeline.
template <class Item, class Fill, class Work, class Consume>
void run_in_order(unsigned jobs, std::size_t count, Fill fill, Work work, Consume consume) {
  OrderedPipeline<Item, Fill, Work, Consume>(jobs, count, fill, work, consume).run();
}

}  // namespace discmc::meshing

#endif
