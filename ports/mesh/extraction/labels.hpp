// Extracts the surfaces of all labels of a segmentation, in one pass.
#ifndef DISCMC_MESH_EXTRACTION_LABELS_HPP
#define DISCMC_MESH_EXTRACTION_LABELS_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include <discmc/limits.hpp>

#include "samples/label_value.hpp"
#include "samples/slice_reader.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

struct LabelOptions {
  Border border = Border::closed;
  /// Whether the bits of every label pass a MajorityFilter first.
  bool filters_by_majority = false;
  /// The labels to extract. Default: all except 0.
  std::optional<std::set<LabelValue>> chosen{};
  /// Called after every slice with the number of slices done.
  std::function<void(std::uint32_t)> progress;
  /// This many threads smooth labels, one each. The surfaces are the same.
  unsigned jobs = 1;

  bool selects(LabelValue value) const {
    return value != LabelValue(0) && (!chosen || chosen->count(value) > 0);
  }
};

/// The surface of the voxels of one value.
struct LabelledSurface {
  LabelValue label;
  std::uint64_t voxels = 0;  ///< number with this value, before the filter
  Surface surface;           ///< with the spacing of the volume
};

/// The largest number of labels in a volume.
constexpr std::uint32_t max_labels = 65536;
/// The largest number of scattered values in a slice and the two before it. Neighbours share such
/// values only by chance, so the volume holds no labels, and its surfaces would be noise.
constexpr std::uint32_t max_scattered_labels = 1024;

/// Throws std::invalid_argument for a volume with more than `max_values` values up to a slice.
[[noreturn]] void refuse_values(std::uint32_t slice, std::uint32_t max_values);

/// Distinguishes labels from samples by the positions of their values in the slices.
class ValueScatter {
 public:
  /// Counts adjacent voxels of one value.
  void add(std::uint32_t voxels) {
    voxels_ += voxels;
    ++stretches_;
  }
  /// Throws like refuse_values(). values: number in the slice and the two before it.
  void require_labels(std::uint32_t slice, std::size_t values) const {
    if (values > max_scattered_labels && voxels_ < 2 * stretches_)
      refuse_values(slice, max_scattered_labels);
  }

 private:
  std::uint64_t voxels_ = 0;
  std::uint64_t stretches_ = 0;
};

/// Reads the volume to its end and extracts the surface of every value except 0, the background;
/// labels ascend. volume: from whole_labels(). Throws VolumeError from the reader, and
/// std::invalid_argument if there are too many values; the text names the slice. Cost: memory of
/// the surfaces, and 12 bytes per row of voxels of the current labels. Time: a scan of the box of
/// each label.
std::vector<LabelledSurface> extract_labels(SliceReader& volume, const LabelOptions& options);

}  // namespace discmc::meshing

#endif
