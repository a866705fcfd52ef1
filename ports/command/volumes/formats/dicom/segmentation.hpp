// DICOM segmentations as volumes of labels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "image.hpp"
#include "pictures/srgb.hpp"
#include "volumes/volume.hpp"

class DcmItem;

namespace discmc::command {

/// Opens the frames of a segmentation. A voxel has the number of its segment; a fraction counts
/// from a half on. Overlapping segments are in several volumes, of which options.frame chooses one.
/// Absent slices are empty. info: has only notes.
std::unique_ptr<VolumeReader> open_segmentation(const std::filesystem::path& source,
                                                const std::vector<DicomFrame>& given,
                                                VolumeInfo info, const VolumeOptions& options);

/// Reads the names and colours of the segments.
DicomSegments segments_of(DcmItem& dataset);

/// Converts CIELab values, as DICOM encodes them, to sRGB. They are relative to the white of sRGB,
/// as programs that write segmentations assume.
Srgb srgb_of_cielab(const std::array<std::uint16_t, 3>& encoded);

/// Finds which segments share voxels, slice by slice.
class Overlaps {
 public:
  /// Begins a slice of this many voxels.
  void start_slice(std::size_t voxels);
  /// Adds the voxels of a segment in the current slice: all that are not 0. Size: the slice. Limit:
  /// each segment once per slice. Throws std::length_error if segments overlap in too many ways.
  void add(std::uint32_t segment, const std::uint8_t* voxels);

  /// Returns the layer of each segment, from 0. Segments of one layer do not overlap.
  std::map<std::uint32_t, std::uint32_t> layers(const std::set<std::uint32_t>& segments) const;

 private:
  using Set = std::vector<std::uint32_t>;

  // Each set of segments that shares a voxel has a number; 0 is the empty set.
  std::uint32_t number_with(std::uint32_t before, std::uint32_t segment);

  std::map<std::uint32_t, std::set<std::uint32_t>> neighbours_;  ///< overlapping segments
  std::map<Set, std::uint32_t> numbers_ = {{{}, 0}};
  std::vector<Set> sets_ = {{}};
  std::vector<std::uint32_t> slice_;  ///< set number of each voxel
};

}  // namespace discmc::command
