// The slices of a volume that are present, if its slabs come from several streams.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <discmc/placement.hpp>

namespace discmc::command {

class SlabRanges {
 public:
  /// Adds a range. Returns slices of it that were already present, and then adds nothing. Limit:
  /// all ranges have one depth.
  std::optional<SlabRange> add(const SlabRange& range);

  /// Returns the ranges in order; adjacent ranges are merged.
  std::vector<SlabRange> ranges() const;
  /// Returns the gaps below, between and above the ranges.
  std::vector<SlabRange> missing() const;

 private:
  std::map<std::uint32_t, SlabRange> ranges_;  // keyed by their ends
};

/// Returns text for people, such as "slices 10 to 19 and 30 to 30".
std::string text(const std::vector<SlabRange>& ranges);

}  // namespace discmc::command
