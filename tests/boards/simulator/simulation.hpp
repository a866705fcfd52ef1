// A scan from the first row to the last byte of the stream: scanner, listener and their lines.
#pragma once

#include <csignal>

#include "line.hpp"
#include "options.hpp"
#include "received.hpp"

namespace discmc::simulator {

/// Set by a signal handler: the simulation ends as soon as it can.
inline volatile std::sig_atomic_t is_interrupted = 0;

class Simulation {
 public:
  struct Lines {
    Line& rows;
    Line& stream;
    Line* monitor;  ///< null if unused
  };

  /// Owner: the caller, of all members, which outlive the simulation.
  Simulation(const Rows& rows, const Options& options, const Lines& lines);

  /// Scans until the trailer of the stream arrives, and prints the progress on standard error.
  /// Throws std::runtime_error if the device is silent, closes the line, does not fit the volume,
  /// or is interrupted.
  void run();

  const Scanner& scanner() const { return scanner_; }
  const Received& received() const { return received_; }
  /// Returns the number of the last scan's regions that had arrived when its last row was sent.
  std::uint64_t early_regions() const { return early_regions_; }
  Clock::duration duration() const { return duration_; }

 private:
  void wait(Clock::time_point now);
  void receive(Clock::time_point now);
  void listen(Clock::time_point now);
  void speak(Clock::time_point now);
  void reset();
  void check_header();
  void check_silence(Clock::time_point now) const;
  void show(Clock::time_point now);
  void note(const std::string& text) const;

  const Rows& rows_;
  const Options& options_;
  Lines lines_;
  Scanner scanner_;
  Listener listener_;
  Received received_;
  bool was_reset_ = false;
  std::uint64_t early_regions_ = 0;
  Clock::time_point last_sign_{};  // of the device
  Clock::time_point next_show_{};
  Clock::duration duration_{};
};

}  // namespace discmc::simulator
