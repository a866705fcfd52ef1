// Proves by exhaustion that the sweep of every block of 3 x 3 x 3 voxels is correct. See usage.
#include <time.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cinttypes>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "block_prover.hpp"
#include "oracle/thinned.hpp"

using namespace discmc;
using namespace discmc::prove;

namespace {

constexpr const char* usage = R"(usage: prove [--share N] [--threads N] [--state FILE]

Sweeps all 134,217,728 blocks of 3x3x3 voxels, with a closed and with an open border, and checks of
each: rings are closed; every link, but those where an open volume ends, is used once in either
direction or not at all; the regions are those of the reference.
  --share N     a part: one in N of the blocks' first two slices; 307 takes some seconds
                (under an address sanitizer one in 37 of these)
  --threads N   as many at once; by default one for each processor
  --state FILE  where to write what is proved, and to go on from when called again
Exit code: 0 proved, 1 a block is wrong (it is named), 2 usage.
)";

struct Options {
  uint32_t share = 1;
  uint32_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::string state;
};

[[noreturn]] void fail(const std::string& reason) {
  std::fprintf(stderr, "prove: %s\n", reason.c_str());
  std::exit(2);
}

uint32_t number_in(const char* option, const char* text) {
  char* end = nullptr;
  const long value = std::strtol(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value < 1 || value > 1000000)
    fail(std::string(option) + " takes a number from 1 to 1000000, not '" + text + "'");
  return static_cast<uint32_t>(value);
}

Options options_of(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string name = arguments[i];
    if (name == "--help") {
      std::fputs(usage, stdout);
      std::exit(0);
    }
    if (name != "--share" && name != "--threads" && name != "--state")
      fail("no option '" + name + "'; see --help");
    if (++i == count) fail(name + " takes a value; see --help");
    if (name == "--state") options.state = arguments[i];
    if (name == "--share") options.share = number_in("--share", arguments[i]);
    if (name == "--threads") options.threads = number_in("--threads", arguments[i]);
  }
  if (options.share > 1) options.share *= reference::step(37);
  if (options.share > 1 && !options.state.empty())
    fail("--state is for all blocks; leave it out with --share");
  return options;
}

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

// The proved first slices of blocks. The file has one line per slice.
class Progress {
 public:
  explicit Progress(const std::string& path) {
    if (path.empty()) return;
    file_ = std::fopen(path.c_str(), "a+");
    if (file_ == nullptr) fail("cannot write " + path);
    uint32_t slice = 0;
    uint64_t blocks = 0;
    double seconds = 0;
    while (std::fscanf(file_, "%" SCNu32 " %" SCNu64 " %lf\n", &slice, &blocks, &seconds) == 3)
      if (slice < slice_values && !is_proved_[slice]) count(slice, blocks, seconds);
    before_ = slices_;
  }
  ~Progress() {
    if (file_ != nullptr) std::fclose(file_);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void add(uint32_t slice, uint64_t blocks, double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    count(slice, blocks, seconds);
    if (file_ == nullptr) return;
    std::fprintf(file_, "%" PRIu32 " %" PRIu64 " %.3f\n", slice, blocks, seconds);
    std::fflush(file_);
  }

  bool is_proved(uint32_t slice) const { return is_proved_[slice]; }
  uint32_t slices() const { return slices_; }
  uint64_t blocks() const { return blocks_; }
  double seconds() const { return seconds_; }

  void print() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const double rate = (slices_ - before_) / elapsed.count();
    if (rate == 0) return;
    std::fprintf(stderr, "prove: %u of %u slices, %.0f blocks a second, %.1f minutes left\n",
                 slices_, slice_values, rate * static_cast<double>(blocks_) / slices_,
                 (slice_values - slices_) / rate / 60);
  }

 private:
  void count(uint32_t slice, uint64_t blocks, double seconds) {
    is_proved_[slice] = true;
    ++slices_;
    blocks_ += blocks;
    seconds_ += seconds;
  }

  std::FILE* file_ = nullptr;
  std::mutex mutex_;
  std::array<bool, slice_values> is_proved_{};
  uint32_t before_ = 0;
  uint32_t slices_ = 0;
  uint64_t blocks_ = 0;
  double seconds_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Threads that prove one slice after another, until all are proved or a block is wrong.
class Proof {
 public:
  Proof(const Options& options, Progress& progress) : options_(options), progress_(progress) {
    for (uint32_t slice = 0; slice < slice_values; ++slice)
      if (!progress.is_proved(slice)) slices_.push_back(slice);
  }

  /// Returns the fault, or an empty text.
  std::string run() {
    std::vector<std::thread> threads;
    running_ = options_.threads;
    for (uint32_t i = 0; i < options_.threads; ++i) threads.emplace_back([this] { work(); });
    wait();
    for (std::thread& thread : threads) thread.join();
    return flaw_;
  }

 private:
  void work() {
    std::string flaw;
    try {
      BlockProver closed(closed_);
      BlockProver open(open_);
      for (size_t i = next_++; i < slices_.size(); i = next_++) {
        const double begin = processor_seconds();
        const uint64_t blocks = closed.prove(slices_[i], options_.share);
        open.prove(slices_[i], options_.share);
        progress_.add(slices_[i], blocks, processor_seconds() - begin);
      }
    } catch (const std::exception& error) {
      flaw = error.what();
      next_ = slices_.size();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (flaw_.empty()) flaw_ = flaw;
    --running_;
    ended_.notify_one();
  }

  // Prints the progress every ten seconds.
  void wait() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::seconds(10), [this] { return running_ == 0; }))
      progress_.print();
  }

  const Options& options_;
  Progress& progress_;
  const Tables closed_{Border::closed};
  const Tables open_{Border::open};
  std::vector<uint32_t> slices_;  // not proved yet
  std::atomic<size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable ended_;
  uint32_t running_ = 0;
  std::string flaw_;
};

}  // namespace

int main(int count, char** arguments) {
  const Options options = options_of(count, arguments);
  Progress progress(options.state);
  const std::string flaw = Proof(options, progress).run();
  if (!flaw.empty()) {
    std::fprintf(stderr, "prove: %s\n", flaw.c_str());
    return 1;
  }
  std::printf("prove: %" PRIu64
              " blocks of 3 x 3 x 3 voxels, each with a closed and an open border:"
              " all as they should be; %.0f seconds of processor time\n",
              progress.blocks(), progress.seconds());
  return 0;
}
