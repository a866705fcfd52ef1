// Progress of a job on standard error, when that is a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace discmc::command {

/// "extracting 45 %"; where all is not known (0), "row 45", or the phase alone.
std::string progress_text(const std::string& phase, std::uint64_t done, std::uint64_t all);

/// A phase of a job. It is shown in place a few times per second, and cleared when all is done or
/// the phase ends. One that begins within another takes its place.
class Progress {
 public:
  /// all: 0 when not known.
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
