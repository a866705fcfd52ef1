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

/// Makes the one frame of a mosaic the frames of its slices, each where it lies, and takes the
/// extents of a slice into the image. Returns why that cannot be, or nothing.
///
/// The slices lie in rows, in the smallest square that holds them. The position in such a
/// file is that of a picture as large as the mosaic with the same centre as the first slice;
/// the way to the next slice is that of SliceNormalVector in the CSA header (nibabel's "Siemens
/// mosaic format" and dcm2niix describe it alike).
NoSlices unfold_mosaic(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

}  // namespace discmc::command

#endif
