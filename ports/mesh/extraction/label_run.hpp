// The slices in which a label appears, through an extractor of their own.
#ifndef DISCMC_MESH_EXTRACTION_LABEL_RUN_HPP
#define DISCMC_MESH_EXTRACTION_LABEL_RUN_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <discmc/extractor.hpp>
#include <discmc/sink.hpp>

#include "own_filter.hpp"
#include "surface/growing_joiner.hpp"

namespace discmc::meshing {

/// Scans the voxels of one label from the first slice that has one to the last. So a label costs
/// nothing in slices where it is not; one that comes back is scanned by a further run.
class LabelRun {
 public:
  /// What a run takes while it lasts, about. Units: bytes.
  static std::uint64_t bytes_for(const Limits& limits);

  /// limits: of the volume. first: the number of the first slice with a voxel of the label.
  /// takes_majority: whether the bits pass a MajorityFilter. sink: must take everything at once;
  /// Owner: the caller.
  LabelRun(const Limits& limits, std::uint32_t first, bool takes_majority, const Sink& sink);

  /// Turns on voxels of the slice under way: of row y, from begin to before end.
  void set(std::uint32_t y, std::uint32_t begin, std::uint32_t end);

  /// Takes the slice under way, and begins the next one with all voxels off.
  void end_slice();

  /// Whether no later slice can change the surface of those so far, filtered or not.
  bool is_over() const { return slices_without_voxels_ == 2; }

  /// Delivers what is left. Call it once, last.
  void finish();

 private:
  void push(const std::uint8_t* row);

  Limits limits_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> slice_;  // bits
  bool has_voxels_ = false;          // the slice
  unsigned slices_without_voxels_ = 0;
  std::unique_ptr<OwnFilter> filter_;  // or none
  GrowingJoiner joiner_;
  std::unique_ptr<std::uint8_t[]> arena_;
  Extractor32 extractor_;
};

}  // namespace discmc::meshing

#endif
