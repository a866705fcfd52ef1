#include "slab_ranges.hpp"

#include <algorithm>

namespace discmc::command {

std::optional<SlabRange> SlabRanges::add(const SlabRange& range) {
  const auto next = ranges_.upper_bound(range.first);
  if (next != ranges_.end() && next->second.first < range.end()) {
    const std::uint32_t first = std::max(next->second.first, range.first);
    return SlabRange{first, std::min(next->first, range.end()) - first, range.depth};
  }
  SlabRange added = range;
  if (const auto before = ranges_.find(range.first); before != ranges_.end()) {
    added = {before->second.first, before->second.slices + range.slices, range.depth};
    ranges_.erase(before);
  }
  if (next != ranges_.end() && next->second.first == range.end()) {
    next->second = {added.first, added.slices + next->second.slices, range.depth};
    return std::nullopt;
  }
  ranges_.emplace_hint(next, added.end(), added);
  return std::nullopt;
}

std::vector<SlabRange> SlabRanges::ranges() const {
  std::vector<SlabRange> ranges;
  for (const auto& [end, range] : ranges_) ranges.push_back(range);
  return ranges;
}

std::vector<SlabRange> SlabRanges::missing() const {
  std::vector<SlabRange> missing;
  if (ranges_.empty()) return missing;
  const std::uint32_t depth = ranges_.begin()->second.depth;
  std::uint32_t first = 0;
  const auto end_at = [&](std::uint32_t end) {
    if (end > first) missing.push_back({first, end - first, depth});
  };
  for (const auto& [end, range] : ranges_) {
    end_at(range.first);
    first = end;
  }
  end_at(depth);
  return missing;
}

std::string text(const std::vector<SlabRange>& ranges) {
  std::string text = "slices ";
  for (std::size_t i = 0; i < ranges.size(); ++i)
    text += (i == 0                  ? ""
             : i + 1 < ranges.size() ? ", "
                                     : " and ") +
            std::to_string(ranges[i].first) + " to " + std::to_string(ranges[i].end() - 1);
  return text;
}

}  // namespace discmc::command
