#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace discmc::host {
namespace {

constexpr std::chrono::milliseconds interval{100};

}  // namespace

Progress::Progress(const char* what, std::uint64_t all)
    : what_(what),
      all_(all),
      is_shown_(isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + interval) {}

Progress::~Progress() {
  if (is_shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::uint64_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!is_shown_ || now < next_) return;
  next_ = now + interval;
  std::fprintf(stderr, "\r%s %llu", what_, static_cast<unsigned long long>(done));
  if (all_ > 0) std::fprintf(stderr, "/%llu", static_cast<unsigned long long>(all_));
  std::fflush(stderr);
}

}  // namespace discmc::host
