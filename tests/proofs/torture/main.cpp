// Scans generated volumes in many ways, which must all give one surface. See usage.
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "draw.hpp"
#include "oracle/agreement.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using namespace discmc::torture;

namespace {

constexpr const char* usage = R"(usage: torture [--seed N] [--cases N | --seconds N] [--jobs N]

Scans generated volumes whole and in slabs, by all kinds of extractors, in memory from the least to plenty,
with refusals and checkpoints. All ways must give one surface; small volumes are compared with the reference.
  --seed N     the first case; each case counts one on (default: 1)
  --cases N    stop after this many cases (default: 100)
  --seconds N  stop after this time instead
  --jobs N     this many processes at once (default: 1)
A case of more than five minutes of processor time is a finding, too.
Exit code: 0 one surface each, 1 a finding, 2 usage.
)";

struct Options {
  uint64_t seed = 1;
  uint64_t cases = 100;
  uint64_t seconds = 0;
  uint64_t jobs = 1;
};

[[noreturn]] void fail(const std::string& reason) {
  std::fprintf(stderr, "torture: %s; see --help\n", reason.c_str());
  std::exit(2);
}

uint64_t number_in(const char* text) {
  char* end = nullptr;
  const unsigned long long number = std::strtoull(text, &end, 10);
  if (*text < '0' || *text > '9' || *end != '\0')
    fail(std::string("invalid number '") + text + "'");
  return number;
}

Options options_of(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string name = arguments[i];
    if (name == "--help") {
      std::fputs(usage, stdout);
      std::exit(0);
    }
    uint64_t* const option = name == "--seed"      ? &options.seed
                             : name == "--cases"   ? &options.cases
                             : name == "--seconds" ? &options.seconds
                             : name == "--jobs"    ? &options.jobs
                                                   : nullptr;
    if (option == nullptr) fail("unknown option '" + name + "'");
    if (++i == count) fail(name + " needs a number");
    *option = number_in(arguments[i]);
  }
  if (options.jobs < 1 || options.jobs > 64) fail("--jobs is from 1 to 64");
  return options;
}

// The progress of a process. Its parent reads it when the process has ended.
struct Progress {
  uint64_t seed;
  uint64_t cases;
  uint64_t scans;
  bool is_done;
  char text[6000];

  void note(const std::string& what) { std::snprintf(text, sizeof text, "%s", what.c_str()); }
};

Surface surface_of(const PlacedVolume& volume, const Arrangement& arrangement, Progress& progress) {
  std::vector<Pieces> slabs;
  for (const SlabPlan& plan : arrangement.slabs) {
    slabs.push_back(scanned(volume, plan));
    ++progress.scans;
  }
  const SlabPlan& first = arrangement.slabs.front();
  const bool is_whole = slabs.size() == 1 && first.seed % 2 == 0;
  return joined(slabs, volume.below, is_whole ? InputOrder::sweep : InputOrder::any,
                {first.refusals, first.seed});
}

// Compares the scan of a small volume with the reference. Returns the fault, or an empty text.
std::string unlike_reference(const PlacedVolume& volume) {
  const reference::BitVolume voxels = reference::volume_of(volume.size, volume.on);
  const bool is_closed = volume.border == Border::closed;
  const reference::Collector collector = reference::scan<uint32_t>(voxels, {volume.border, 0});
  std::string unlike = reference::miscounted(collector, voxels, is_closed);
  if (unlike.empty()) unlike = reference::unlike_merge(collector.regions(), voxels, is_closed);
  return unlike.empty() ? reference::unlike_surface(collector.regions(), voxels, is_closed)
                        : unlike;
}

// A signal ends an endless loop.
void limit_processor_time() {
  const itimerval five_minutes{{0, 0}, {300, 0}};
  setitimer(ITIMER_PROF, &five_minutes, nullptr);
}

// First a host for the whole volume and for thin slabs, whose queues grow most; then any
// extractors.
std::vector<Arrangement> draw_arrangements(const PlacedVolume& volume, const shapes::Below& below) {
  constexpr size_t count = 6;
  std::vector<Arrangement> all{in_much_memory(volume, Scanner::host, volume.size.depth),
                               in_much_memory(volume, Scanner::host, 1 + below(2))};
  while (all.size() < count) all.push_back(draw_arrangement(volume, below));
  return all;
}

// Returns the fault, or an empty text; progress.text describes the last scan.
std::string fault_of(Progress& progress) {
  test::Chance chance(progress.seed);
  const shapes::Below below = [&](uint32_t limit) { return chance.below(limit); };
  progress.note("");
  const DrawnVolume subject = draw_volume(below);
  const PlacedVolume& volume = subject.volume;
  progress.note(subject.text + ", reference");
  if (subject.is_small) {
    const std::string unlike = unlike_reference(volume);
    if (!unlike.empty()) return unlike;
  }
  Surface expected =
      surface_of(volume, in_much_memory(volume, Scanner::wide, volume.size.depth), progress);
  for (const Arrangement& arrangement : draw_arrangements(volume, below)) {
    progress.note(subject.text + ": " + arrangement.text);
    Surface surface = surface_of(volume, arrangement, progress);
    const std::string difference = surface.difference(expected, arrangement.slabs.size() - 1);
    if (!difference.empty()) return difference;
  }
  return {};
}

class Torture {
 public:
  Torture(const Options& options, const char* program)
      : options_(options),
        program_(program),
        end_(Clock::now() + std::chrono::seconds(options.seconds)) {
    void* const shared = mmap(nullptr, options.jobs * sizeof(Progress), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) fail("no memory");
    progress_ = static_cast<Progress*>(shared);
  }

  int run() {
    std::printf("torture: cases from seed %" PRIu64 " on\n", options_.seed);
    std::fflush(stdout);
    for (uint64_t job = 0; job < options_.jobs; ++job) {
      progress_[job].seed = options_.seed + job;
      begin(job);
    }
    int status = 0;
    for (pid_t child; (child = wait(&status)) > 0;)
      for (uint64_t job = 0; job < options_.jobs; ++job)
        if (children_[job] == child) process_end(job, status);
    print();
    return findings_ == 0 ? 0 : 1;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_over(const Progress& progress) const {
    return options_.seconds > 0 ? Clock::now() >= end_
                                : progress.seed >= options_.seed + options_.cases;
  }

  void begin(uint64_t job) {
    children_[job] = fork();
    if (children_[job] < 0) fail("cannot fork");
    if (children_[job] == 0) _exit(work(progress_[job]));
  }

  // Runs in a process of its own. If it crashes, the parent still has `progress`.
  int work(Progress& progress) {
    for (; !is_over(progress); progress.seed += options_.jobs, ++progress.cases) {
      try {
        limit_processor_time();
        const std::string fault = fault_of(progress);
        if (fault.empty()) continue;
        std::fprintf(stderr, "torture: %s\n", fault.c_str());
      } catch (const std::exception& error) {
        std::fprintf(stderr, "torture: %s\n", error.what());
      }
      return 1;
    }
    progress.is_done = true;
    return 0;
  }

  void process_end(uint64_t job, int status) {
    Progress& progress = progress_[job];
    if (progress.is_done) return;
    ++findings_;
    std::printf("torture: finding: seed %" PRIu64 ", %s %d\n  %s\n  repeat: %s --seed %" PRIu64
                " --cases 1\n",
                progress.seed, WIFSIGNALED(status) ? "signal" : "exit code",
                WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status), progress.text,
                program_, progress.seed);
    std::fflush(stdout);
    progress.seed += options_.jobs;
    ++progress.cases;
    begin(job);
  }

  void print() const {
    uint64_t cases = 0, scans = 0;
    for (uint64_t job = 0; job < options_.jobs; ++job) {
      cases += progress_[job].cases;
      scans += progress_[job].scans;
    }
    std::printf("torture: %" PRIu64 " volumes, %" PRIu64 " scans, %" PRIu64 " findings\n", cases,
                scans, findings_);
  }

  Options options_;
  const char* program_;
  Clock::time_point end_;
  Progress* progress_ = nullptr;
  std::vector<pid_t> children_ = std::vector<pid_t>(options_.jobs);
  uint64_t findings_ = 0;
};

}  // namespace

int main(int count, char** arguments) {
  return Torture(options_of(count, arguments), arguments[0]).run();
}
