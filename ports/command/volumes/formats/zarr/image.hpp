// Which array of a folder of Zarr is the volume, and its description in OME-Zarr.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "description.hpp"
#include "volumes/declared_values.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

struct ZarrAxis {
  char letter = 0;     ///< x, y, z, c, or t for all others
  double scale = 1;    ///< from a sample to the next one
  double origin = 0;   ///< where the first one lies
  std::string unit{};  ///< "micrometer"
  /// The name and the places of samples, as xarray has them; or none.
  std::string name{};
  std::vector<double> coordinates{};
};

struct ZarrImage {
  LabelTable labels;  ///< of an image of labels
  ZarrDescription array;
  std::vector<ZarrAxis> axes{};  ///< of the array; none if there is no description
  bool is_ome = false;
  DeclaredValues values{};  ///< as xarray has them
  bool has_scale = false;
  std::vector<std::string> channels{};  ///< their names, where there are any
  std::string level{};                  ///< for people, of several: "level 1 of 4"
};

/// Throws VolumeError where it is none, or holds several images.
ZarrImage read_zarr_image(const std::filesystem::path& folder, const VolumeOptions& options);

}  // namespace discmc::command
