// Mosaics of Siemens: the slices of a volume side by side in one picture.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_MOSAIC_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_MOSAIC_HPP

#include <string>
#include <vector>

#include "image.hpp"

class DcmItem;

namespace discmc::command {

/// Whether a file holds such a picture, or that of United Imaging, which is alike.
bool is_mosaic(DcmItem& dataset);

/// Replaces the one frame of a mosaic by the frames of its slices, each in its place, and its
/// extents by a slice's. Returns why that cannot be, or nothing.
///
/// The slices lie in rows, in the smallest square that holds them. The position in such a file
/// belongs to a picture as large as the mosaic with the centre of the first slice.
/// SliceNormalVector in the CSA header is the direction to the next slice (nibabel's "Siemens
/// mosaic format" and dcm2niix agree).
NoSlices unfold_mosaic(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

}  // namespace discmc::command

#endif
