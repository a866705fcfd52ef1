// Which slices of a volume are there, when its slabs come from several streams.
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
  /// Returns slices that were there before, and then has not changed. Limit: all of one depth.
  std::optional<SlabRange> add(const SlabRange& range);

  /// In order, those that touch each other as one.
  std::vector<SlabRange> ranges() const;
  /// What lies between them, below and above.
  std::vector<SlabRange> missing() const;

 private:
  std::map<std::uint32_t, SlabRange> ranges_;  // by their ends
};

/// "slices 10 to 19 and 30 to 30", for people.
std::string text(const std::vector<SlabRange>& ranges);

}  // namespace discmc::command
