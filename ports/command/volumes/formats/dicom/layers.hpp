// Which segments of a DICOM segmentation overlap.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_LAYERS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_LAYERS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace discmc::command {

/// Finds which segments have voxels in common, slice by slice.
class Overlaps {
 public:
  /// Begins a slice of this many voxels.
  void start_slice(std::size_t voxels);
  /// Adds the voxels of a segment in that slice: those that are not 0. Size: those of the slice.
  /// Limit: a segment once a slice. Throws std::length_error where segments overlap in too many
  /// ways.
  void add(std::uint32_t segment, const std::uint8_t* voxels);

  /// Returns the number of the layer of each segment, from 0: those of a layer do not overlap.
  std::map<std::uint32_t, std::uint32_t> layers(const std::set<std::uint32_t>& segments) const;

 private:
  using Set = std::vector<std::uint32_t>;

  // Every set of segments that some voxel is of has a number; 0 is that of none.
  std::uint32_t number_with(std::uint32_t before, std::uint32_t segment);

  std::map<std::uint32_t, std::set<std::uint32_t>> neighbours_;  ///< that overlap a segment
  std::map<Set, std::uint32_t> numbers_ = {{{}, 0}};
  std::vector<Set> sets_ = {{}};
  std::vector<std::uint32_t> slice_;  ///< by voxel the number of its set
};

}  // namespace discmc::command

#endif
