#include "slab_ranges.hpp"

#include <algorithm>

namespace discmc::command {

std::optional<SlabRange> SlabRanges::add(const SlabRange& range) {
  const auto next = std::find_if(ranges_.begin(), ranges_.end(), [&range](const SlabRange& each) {
    return each.end() > range.first;
  });
  if (next != ranges_.end() && next->first < range.end()) {
    const std::uint32_t first = std::max(next->first, range.first);
    return SlabRange{first, std::min(next->end(), range.end()) - first, range.depth};
  }
  auto added = ranges_.insert(next, range);
  if (added + 1 != ranges_.end() && added->end() == (added + 1)->first) {
    added->slices += (added + 1)->slices;
    added = ranges_.erase(added + 1) - 1;
  }
  if (added != ranges_.begin() && (added - 1)->end() == added->first) {
    (added - 1)->slices += added->slices;
    ranges_.erase(added);
  }
  return std::nullopt;
}

std::vector<SlabRange> SlabRanges::missing() const {
  std::vector<SlabRange> missing;
  if (ranges_.empty()) return missing;
  const std::uint32_t depth = ranges_[0].depth;
  std::uint32_t first = 0;
  const auto end_at = [&](std::uint32_t end) {
    if (end > first) missing.push_back({first, end - first, depth});
  };
  for (const SlabRange& range : ranges_) {
    end_at(range.first);
    first = range.end();
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
