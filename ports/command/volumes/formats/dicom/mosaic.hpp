// Mosaics of Siemens: the slices of a volume side by side in one picture.
#pragma once

#include <map>
#include <string>
#include <string_view>
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

/// The values of each element, as text without blanks.
using CsaHeader = std::map<std::string, std::vector<std::string>>;

/// Reads a CSA image header, of the newer kind (SV10) or the older. Any bytes have a content: what
/// is before the first damage.
CsaHeader read_csa_header(std::string_view bytes);

}  // namespace discmc::command
