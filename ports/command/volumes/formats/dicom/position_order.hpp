// Slices in the order of their positions, one step from each other.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_POSITION_ORDER_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_POSITION_ORDER_HPP

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "image.hpp"
#include "vectors.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// The place of a first slice, and the way to the next one.
struct SliceLine {
  Vector origin{};
  Vector step{};
};

/// Whether two frames have the same pixels.
using SamePixels = std::function<bool(const DicomFrame&, const DicomFrame&)>;

/// Puts frames with places in the order of these, each place once, and fills gaps if that is
/// allowed. Adds to the notes what was assumed. Throws VolumeError where slices are missing
/// otherwise, are not as far from each other everywhere, or not on one line.
SliceLine order_by_position(const std::filesystem::path& source, VolumeInfo& info,
                            std::vector<DicomFrame>& stack, const SamePixels& same_pixels,
                            bool allow_gaps);

/// Fills the places of slices whose numbers are left out, with a note, or refuses them.
/// places: of each slice, for people.
void fill_missing(const std::filesystem::path& source, VolumeInfo& info,
                  std::vector<DicomFrame>& stack, const std::vector<std::uint64_t>& numbers,
                  const std::vector<std::string>& places, bool allow_gaps);

}  // namespace discmc::command

#endif
