// The places and values of frames that one file describes as a whole: doses, nuclear medicine, cone
// beams.
#pragma once

#include <string>
#include <vector>

#include "image.hpp"

class DcmItem;

namespace discmc::command {

/// Whether functional groups have the positions, and not the file as a whole.
bool have_own_positions(DcmItem& dataset);

/// Moves the frames of a file to where each lies, if the file has one place for all of them. Adds
/// to the notes of the image what was assumed. Returns why that cannot be, or nothing.
NoSlices place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

/// Moves frames from the place of the first, which all of them have, by steps along the normal.
/// slices: of each frame its number in the stack.
void place_by_steps(DicomImage& image, std::vector<DicomFrame>& frames,
                    const std::vector<std::uint32_t>& slices);

// Parts of place_frames(), of files of the kind.

/// Takes the scale of a dose, with a note of its unit.
void scale_dose(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

/// Moves the frames of a grid by their offsets from its position.
NoSlices place_by_offsets(DcmItem& dataset, std::vector<DicomFrame>& frames);

/// Places slices of nuclear medicine.
NoSlices place_nuclear(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

}  // namespace discmc::command
