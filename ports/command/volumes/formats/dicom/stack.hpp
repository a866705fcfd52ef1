// DICOM frames that make a volume: found among many, put in order, and checked.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_STACK_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_STACK_HPP

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "image.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Frames of one series, of one size, sample type and direction.
using DicomStack = std::vector<DicomFrame>;

/// Returns the stacks of all frames, by the numbers of their series.
std::vector<DicomStack> dicom_stacks(const std::vector<DicomFrame>& frames);

/// Returns the stack of the series, given by its UID or by its place in the list, from 1; of one
/// stack also without. Throws VolumeError, with the list, where none is meant or several are.
const DicomStack& chosen_stack(const std::filesystem::path& source,
                               const std::vector<DicomStack>& stacks, const std::string& series);

/// Whether one slope and intercept is of all frames.
bool have_one_scale(const DicomStack& stack);

/// Whether two frames have the same pixels.
using SamePixels = std::function<bool(const DicomFrame&, const DicomFrame&)>;

/// Puts the frames in the order of their positions along the normal, each position once, and
/// describes the volume that they are. options: whether missing slices are filled with the
/// nearest ones, and the spacing. Throws VolumeError where slices are missing otherwise, are not as
/// far from each other everywhere, or are shifted against each other.
VolumeInfo order_stack(const std::filesystem::path& source, DicomStack& stack,
                       const SamePixels& same_pixels, const VolumeOptions& options);

}  // namespace discmc::command

#endif
