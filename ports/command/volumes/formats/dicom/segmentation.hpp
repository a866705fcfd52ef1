// DICOM segmentations as volumes of labels.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_SEGMENTATION_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_SEGMENTATION_HPP

#include <filesystem>
#include <memory>
#include <vector>

#include "image.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Opens the frames of one segmentation. A voxel has the number of the segment that it is of; one
/// of fractions is of a segment from a half on. Segments that overlap are in several volumes, of
/// which the frame of the options is one. Slices that are not there are empty. info: with notes
/// alone.
std::unique_ptr<VolumeReader> open_segmentation(const std::filesystem::path& source,
                                                const std::vector<DicomFrame>& given,
                                                VolumeInfo info, const VolumeOptions& options);

}  // namespace discmc::command

#endif
