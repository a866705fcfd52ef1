// The scanner: its frames, and their times.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "rows.hpp"

namespace discmc::simulator {

using Clock = std::chrono::steady_clock;

/// The pace of the scanner, and its faults.
struct ScannerBehaviour {
  static constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();

  std::chrono::microseconds pace{0};                          ///< minimum time between rows
  std::chrono::microseconds jitter{0};                        ///< maximum deviation from the pace
  std::map<std::uint32_t, std::chrono::milliseconds> pauses;  ///< pauses before these rows
  std::set<std::uint32_t> dropped;                            ///< rows that are not sent
  std::set<std::uint32_t> damaged;      ///< rows that are sent with a wrong byte
  std::uint32_t broken_off_at = never;  ///< the scan ends before this row
  bool waits_for_credit = true;         ///< otherwise the scanner keeps its pace
};

/// Reacts to the device's answers and to time. The owner carries bytes between the scanner and the
/// line.
class Scanner {
 public:
  /// Owner: the caller, of rows and behaviour, which outlive the scanner.
  Scanner(const Rows& rows, const ScannerBehaviour& behaviour);

  /// Processes an answer. Throws std::runtime_error if the device refuses the scan.
  void receive(std::uint8_t answer, Clock::time_point now);

  /// Returns the bytes to send now; none if it is too early.
  std::vector<std::uint8_t> next(Clock::time_point now);

  /// Returns the time of the next call of next(), unless an answer arrives earlier.
  Clock::time_point due() const;

  bool is_scanning() const { return stage_ == Stage::scanning; }
  bool has_sent_all() const { return stage_ == Stage::ending; }
  /// Returns the next row, or the number of rows after has_sent_all().
  std::uint32_t row() const { return row_; }
  std::uint32_t row_count() const { return end_; }
  /// Returns how often the device restarted during the scan.
  std::uint32_t restarts() const { return restarts_; }
  /// Returns the number of dropped frames in the device's answers.
  std::uint32_t drops() const { return drops_; }
  /// Returns the longest time for which a row that was due waited for the device.
  Clock::duration longest_wait() const { return longest_wait_; }

 private:
  enum class Stage : std::uint8_t { starting, scanning, ending };

  void begin(Clock::time_point now);
  std::vector<std::uint8_t> next_row(Clock::time_point now);
  void schedule(Clock::time_point now);
  bool waits_for_device() const;

  const Rows& rows_;
  const ScannerBehaviour& behaviour_;
  std::uint32_t end_;
  std::minstd_rand chance_;  // the same seed in every run
  Stage stage_ = Stage::starting;
  Clock::time_point due_{};  // time of the next row, or of a repeated start or end
  std::uint32_t row_ = 0;
  int credit_ = 0;
  std::uint32_t restarts_ = 0;
  std::uint32_t drops_ = 0;
  Clock::duration longest_wait_{0};
};

}  // namespace discmc::simulator
