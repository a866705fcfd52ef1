// The slices of a DICOM volume in their order, and where they lie.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_ORDER_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_ORDER_HPP

#include <filesystem>
#include <optional>
#include <vector>

#include "image.hpp"
#include "position_order.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Takes spacing and placement of slices that are alike, with notes of what is missing. Without a
/// line they lie in no space.
void set_slice_line(VolumeInfo& info, const DicomFrame& first, const std::optional<SliceLine>& line,
                    const VolumeOptions& options);

/// Whether one slope and intercept is of all frames.
bool have_one_scale(const std::vector<DicomFrame>& stack);

/// Orders the frames by position, each position once, or as the options ask. Adds to the info what
/// volume they are. Throws VolumeError where slices are missing and gaps are not allowed, are not
/// as far from each other everywhere, or not on one line.
void order_stack(const std::filesystem::path& source, std::vector<DicomFrame>& stack,
                 const SamePixels& same_pixels, const VolumeOptions& options, VolumeInfo& info);

}  // namespace discmc::command

#endif
