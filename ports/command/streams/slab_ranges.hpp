// Which slices of a volume are there, when its slabs come from several streams.
#ifndef DISCMC_COMMAND_STREAMS_SLAB_RANGES_HPP
#define DISCMC_COMMAND_STREAMS_SLAB_RANGES_HPP

#include <cstdint>
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
  const std::vector<SlabRange>& ranges() const { return ranges_; }
  /// What lies between them, below and above.
  std::vector<SlabRange> missing() const;

 private:
  std::vector<SlabRange> ranges_;
};

/// "slices 10 to 19 and 30 to 30", for people.
std::string text(const std::vector<SlabRange>& ranges);

}  // namespace discmc::command

#endif
