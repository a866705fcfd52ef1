// The surfaces of all labels of a segmentation, in one pass over it.
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
  bool takes_majority = false;
  /// The labels that are taken; else all but 0.
  std::optional<std::set<LabelValue>> chosen{};
  /// Called after every slice with how many are done.
  std::function<void(std::uint32_t)> progress;
  /// This many threads smooth labels, one each. The surfaces are the same.
  unsigned jobs = 1;

  bool takes(LabelValue value) const {
    return value != LabelValue(0) && (!chosen || chosen->count(value) > 0);
  }
};

/// The surface of the voxels of one value.
struct LabelledSurface {
  LabelValue label;
  std::uint64_t voxels = 0;  ///< that have this value, before the filter
  Surface surface;           ///< with the spacing of the volume
};

/// What a volume may hold.
constexpr std::uint32_t max_labels = 65536;
/// The most values in a slice and the two before it whose voxels are neighbours only by chance.
/// Such a volume holds no labels, and its surfaces would be noise.
constexpr std::uint32_t max_scattered_labels = 1024;

/// Throws the std::invalid_argument of a volume that has more values than that up to a slice.
[[noreturn]] void refuse_values(std::uint32_t slice, std::uint32_t most);

/// Distinguishes labels from samples by the positions of their values in the slices.
class ValueScatter {
 public:
  /// Counts voxels of one value side by side.
  void add(std::uint32_t voxels) {
    voxels_ += voxels;
    ++stretches_;
  }
  /// Throws as refuse_values(). values: of the slice and the two before it.
  void require_labels(std::uint32_t slice, std::size_t values) const {
    if (values > max_scattered_labels && voxels_ < 2 * stretches_)
      refuse_values(slice, max_scattered_labels);
  }

 private:
  std::uint64_t voxels_ = 0;
  std::uint64_t stretches_ = 0;
};

/// Reads the volume to its end and extracts the surface of every value except 0, the background;
/// the least label comes first. volume: of whole_labels(). Throws VolumeError as the reader does,
/// std::invalid_argument where there are too many values; the text names the slice. Cost: memory of
/// the surfaces, and 12 bytes per row of voxels of the labels under way. Time of a scan per label,
/// of its box.
std::vector<LabelledSurface> extract_labels(SliceReader& volume, const LabelOptions& options);

}  // namespace discmc::meshing

#endif
