// What DICOM files, and files named as such, hold instead of images.
#pragma once

#include <filesystem>

#include "image.hpp"

class DcmItem;

namespace discmc::command {

/// Names the format of a file by its first bytes if it is another than DICOM; otherwise nothing.
NoSlices foreign_content(const std::filesystem::path& file);

/// Names what a data set without an image is.
NoSlices without_image(DcmItem& dataset);

}  // namespace discmc::command
