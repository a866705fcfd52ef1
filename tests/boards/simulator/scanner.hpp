// The scanner: which frame it sends, and when.
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

/// How the scanner scans, and what goes wrong.
struct ScannerBehaviour {
  static constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();

  std::chrono::microseconds pace{0};                          ///< from row to row, at least
  std::chrono::microseconds jitter{0};                        ///< of the pace, either way, at most
  std::map<std::uint32_t, std::chrono::milliseconds> pauses;  ///< before these rows
  std::set<std::uint32_t> dropped;                            ///< rows that are not sent at all
  std::set<std::uint32_t> damaged;      ///< rows that are sent with a wrong byte
  std::uint32_t broken_off_at = never;  ///< the scan ends before this row
  bool waits_for_credit = true;         ///< else it sends at its pace, come what may
};

/// Follows the answers of the device and its own clock. The owner carries the bytes to and from the
/// line.
class Scanner {
 public:
  /// Owner: the rows and the behaviour belong to the caller and outlive the scanner.
  Scanner(const Rows& rows, const ScannerBehaviour& behaviour);

  /// Takes an answer. Throws std::runtime_error when the device refuses the scan.
  void hear(std::uint8_t answer, Clock::time_point now);

  /// The bytes to send now; none if it is not yet time.
  std::vector<std::uint8_t> next(Clock::time_point now);

  /// The time of the next call of next(), unless an answer comes before.
  Clock::time_point due() const;

  bool is_scanning() const { return stage_ == Stage::scanning; }
  bool has_sent_all() const { return stage_ == Stage::ending; }
  /// The row that comes next; all of them once has_sent_all().
  std::uint32_t row() const { return row_; }
  std::uint32_t row_count() const { return end_; }
  /// How often the device began anew after the scan had begun.
  std::uint32_t restarts() const { return restarts_; }
  /// How many frames the device has dropped, as it answers.
  std::uint32_t drops() const { return drops_; }
  /// The longest time for which a row was due and had to wait for the device.
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
  std::minstd_rand chance_;  // seeded alike in every run
  Stage stage_ = Stage::starting;
  Clock::time_point due_{};  // of the next row, or of the start or end once more
  std::uint32_t row_ = 0;
  int credit_ = 0;
  std::uint32_t restarts_ = 0;
  std::uint32_t drops_ = 0;
  Clock::duration longest_wait_{0};
};

}  // namespace discmc::simulator
