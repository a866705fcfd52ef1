// Positions and values of frames that one file describes together: doses, nuclear medicine, cone
// beams. Also mosaics of Siemens, in which one picture holds all slices of a volume.
#pragma once

#include <vector>

#include "image.hpp"

class DcmItem;

namespace discmc::command {

/// Whether functional groups have the positions, not the file as a whole.
bool have_own_positions(DcmItem& dataset);

/// Moves each frame to its position, if the file has one position for all. Adds assumptions to the
/// notes of the image. Returns why this is impossible, or nothing.
RejectReason place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

/// Whether a file holds a mosaic of Siemens, or the similar one of United Imaging.
bool is_mosaic(DcmItem& dataset);

/// Replaces the single frame of a mosaic by the frames of its slices, each at its position, and the
/// extents by a slice's. Returns why this is impossible, or nothing.
///
/// The slices fill rows of the smallest square that holds them all. The position in the file is
/// that of a picture as large as the mosaic, centred on the first slice. SliceNormalVector in the
/// CSA header is the direction to the next slice (nibabel's "Siemens mosaic format" and dcm2niix
/// agree).
RejectReason unfold_mosaic(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

}  // namespace discmc::command
