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

/// Opens the frames of one segmentation. A voxel has the number of the segment that it is of; one
/// of fractions is of a segment from a half on. Segments that overlap are in several volumes, of
/// which the frame of the options is one. Slices that are not there are empty. info: with notes
/// alone.
std::unique_ptr<VolumeReader> open_segmentation(const std::filesystem::path& source,
                                                const std::vector<DicomFrame>& given,
                                                VolumeInfo info, const VolumeOptions& options);

/// Reads the names and colours of the segments.
DicomSegments segments_of(DcmItem& dataset);

/// Returns the colour of CIELab values as DICOM encodes them, relative to the white of sRGB, as
/// those who write segmentations take them.
Srgb srgb_of_cielab(const std::array<std::uint16_t, 3>& encoded);

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
