#include "progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace discmc::command {
namespace {

constexpr std::chrono::milliseconds interval{100};
constexpr const char* clear_line = "\r\033[K";

}  // namespace

std::string progress_text(const std::string& phase, std::uint64_t done, std::uint64_t all) {
  if (all > 0) return phase + " " + std::to_string(100 * done / all) + " %";
  return done > 0 ? phase + " " + std::to_string(done) : phase;
}

Progress::Progress(std::string phase, std::uint64_t all)
    : phase_(std::move(phase)),
      all_(all),
      is_shown_(isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + interval) {
  if (is_shown_) write(0);
}

Progress::~Progress() {
  if (is_shown_) clear();
}

void Progress::show(std::uint64_t done) {
  if (!is_shown_) return;
  if (all_ > 0 && done >= all_) return clear();
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + interval;
  write(done);
}

void Progress::write(std::uint64_t done) const {
  std::fprintf(stderr, "%s%s", clear_line, progress_text(phase_, done, all_).c_str());
  std::fflush(stderr);
}

void Progress::clear() {
  std::fputs(clear_line, stderr);
  is_shown_ = false;
}

}  // namespace discmc::command
