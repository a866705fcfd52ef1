// Chooses the array of a Zarr folder that is the volume, and reads its OME-Zarr description.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "description.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

struct ZarrAxis {
  char letter = 0;     ///< x, y, z, c, or t for all other axes
  double scale = 1;    ///< distance between neighbouring samples
  double origin = 0;   ///< position of the first sample
  std::string unit{};  ///< "micrometer"
  /// The name and coordinates of xarray, or empty.
  std::string name{};
  std::vector<double> coordinates{};
};

struct ZarrImage {
  LabelTable labels;  ///< for an image of labels
  ZarrDescription array;
  std::vector<ZarrAxis> axes{};  ///< of the array; empty without a description
  bool is_ome = false;
  DeclaredValues values{};  ///< declared by xarray
  bool has_scale = false;
  std::vector<std::string> channels{};  ///< names, or empty
  std::string level{};                  ///< for people, if there are several: "level 1 of 4"
};

/// Throws VolumeError if the folder is not Zarr, or holds several images.
ZarrImage read_zarr_image(const std::filesystem::path& folder, const VolumeOptions& options);

}  // namespace discmc::command
