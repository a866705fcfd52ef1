// Counts missed edges of the sync line.
//
// If the kernel numbers edges (libgpiod 2.x), gaps in the numbers are exact. If not (1.x), the
// kernel drops edges only while its queue is full. After a full queue, the time since the last edge
// is divided by the period of the edges before. The result is exact if the pace of the stage
// changes by less than half a period over the gap. Other long intervals are pauses of the stage;
// they are only counted.
#pragma once

#include <cstdint>
#include <deque>

#include "line_events.hpp"

namespace discmc::device {

class EdgeCounter {
 public:
  /// Processes the next received edge. Returns the number of missed edges before it.
  std::uint32_t missed_before(const LineEvent& edge);

  /// The number of intervals of 1.5 periods or more without missed edges.
  std::uint64_t long_intervals() const { return long_intervals_; }

 private:
  static constexpr std::size_t kept_intervals = 32;

  std::uint32_t missed_by_number(std::uint32_t number);
  std::uint32_t missed_by_time(std::uint64_t interval, bool may_follow_loss);
  double period() const;

  std::uint32_t last_number_ = 0;
  std::uint64_t last_ns_ = 0;
  bool has_last_ = false;
  std::deque<std::uint64_t> intervals_;  // the latest intervals, without those with missed edges
  std::uint64_t long_intervals_ = 0;
};

}  // namespace discmc::device
