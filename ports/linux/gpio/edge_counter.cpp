#include "edge_counter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace discmc::device {

std::uint32_t EdgeCounter::missed_before(const LineEvent& edge) {
  const std::uint64_t interval = edge.time_ns - last_ns_;
  const bool is_first = !has_last_;
  last_ns_ = edge.time_ns;
  has_last_ = true;
  if (edge.number) return missed_by_number(*edge.number);
  return is_first ? 0 : missed_by_time(interval, edge.may_follow_loss);
}

std::uint32_t EdgeCounter::missed_by_number(std::uint32_t number) {
  const std::uint32_t missed = number - last_number_ - 1;  // also after a wrap of 32 bits
  last_number_ = number;
  return missed;
}

std::uint32_t EdgeCounter::missed_by_time(std::uint64_t interval, bool may_follow_loss) {
  const double periods = intervals_.empty() ? 1 : static_cast<double>(interval) / period();
  const bool is_long = periods >= 1.5;
  if (is_long && may_follow_loss)
    return static_cast<std::uint32_t>(std::min(std::round(periods) - 1, 4e9));
  if (is_long) ++long_intervals_;
  if (intervals_.size() == kept_intervals) intervals_.pop_front();
  intervals_.push_back(interval);
  return 0;
}

// The mean of the intervals near the median. Pauses do not affect it, and over many periods it is
// more exact than the median.
double EdgeCounter::period() const {
  std::vector<std::uint64_t> sorted(intervals_.begin(), intervals_.end());
  std::sort(sorted.begin(), sorted.end());
  const std::uint64_t median = sorted[sorted.size() / 2];
  double sum = 0;
  double count = 0;
  for (const std::uint64_t interval : sorted) {
    if (interval < median / 2 || interval > median + median / 2) continue;
    sum += static_cast<double>(interval);
    ++count;
  }
  return std::max(sum / count, 1.0);
}

}  // namespace discmc::device
