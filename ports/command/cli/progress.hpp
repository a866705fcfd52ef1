// Progress of a job on standard error, when that is a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace discmc::command {

/// Example: "extracting 45 %"; if the total is unknown (0), "row 45", or only the phase.
std::string progress_text(const std::string& phase, std::uint64_t done, std::uint64_t all);

/// A phase of a job. The terminal shows it in place a few times per second, until it is done or
/// ends. A phase that begins within another one replaces it on the terminal.
class Progress {
 public:
  /// all: 0 if unknown.
  explicit Progress(std::string phase, std::uint64_t all = 0);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void show(std::uint64_t done);

 private:
  void write(std::uint64_t done) const;
  void clear();

  std::string phase_;
  std::uint64_t all_;
  bool is_shown_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace discmc::command
