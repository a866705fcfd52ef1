// How many edges of the sync line were missed.
//
// Where the kernel numbers the edges (libgpiod 2.x) a gap in the numbers is the answer, and exact.
// If it does not (1.x) it drops edges only while its queue is full. After a full queue, the time
// since the last edge is divided by the period of the edges before it. The answer is right while
// the stage keeps its pace to half a period over the gap. Other long intervals are no loss but a
// stage that stood still; they are only counted.
#pragma once

#include <cstdint>
#include <deque>

#include "line_events.hpp"

namespace discmc::device {

class EdgeCounter {
 public:
  /// Takes the next edge that was seen; returns how many were missed before it.
  std::uint32_t missed_before(const LineEvent& edge);

  /// Intervals of 1.5 periods or more without a sign that edges were missed.
  std::uint64_t long_intervals() const { return long_intervals_; }

 private:
  static constexpr std::size_t kept_intervals = 32;

  std::uint32_t missed_by_number(std::uint32_t number);
  std::uint32_t missed_by_time(std::uint64_t interval, bool may_follow_loss);
  double period() const;

  std::uint32_t last_number_ = 0;
  std::uint64_t last_ns_ = 0;
  bool has_last_ = false;
  std::deque<std::uint64_t> intervals_;  // the latest, without those in which edges were missed
  std::uint64_t long_intervals_ = 0;
};

}  // namespace discmc::device
