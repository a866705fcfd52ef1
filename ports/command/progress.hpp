// Progress on standard error, when that is a terminal.
#ifndef DISCMC_COMMAND_PROGRESS_HPP
#define DISCMC_COMMAND_PROGRESS_HPP

#include <chrono>
#include <cstdint>

namespace discmc::host {

/// Shows "what done/all" in place, a few times a second, and clears the line in the end.
class Progress {
 public:
  /// what: Owner: static storage. all: 0 when not known.
  Progress(const char* what, std::uint64_t all);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void show(std::uint64_t done);

 private:
  const char* what_;
  std::uint64_t all_;
  bool is_shown_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace discmc::host

#endif
