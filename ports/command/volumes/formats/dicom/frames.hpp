// The places and values of frames that one file describes as a whole: doses, nuclear medicine, cone
// beams. Also mosaics of Siemens: the slices of a volume side by side in one picture.
#pragma once

#include <vector>

#include "image.hpp"

class DcmItem;

namespace discmc::command {

/// Whether functional groups have the positions, and not the file as a whole.
bool have_own_positions(DcmItem& dataset);

/// Moves the frames of a file to where each lies, if the file has one place for all of them. Adds
/// to the notes of the image what was assumed. Returns why that cannot be, or nothing.
NoSlices place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

/// Whether a file holds a mosaic, or that of United Imaging, which is alike.
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
