// The position and orientation of voxels, as a file declares them and as the command uses them, and
// the values of arrays. All units, spacings, directions and origins are converted here.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "volume.hpp"

namespace discmc::command {

/// The declaration of the file, in its own units. Missing items stay empty.
struct DeclaredPlace {
  /// Distances between neighbouring voxels along x, y and z, negative along a reversed axis.
  std::array<std::optional<double>, 3> spacing{};
  /// Vectors to the next voxel along each axis. They override the spacing.
  std::optional<Axes> steps{};
  /// Directions of these vectors; the spacing gives their lengths.
  std::optional<Axes> directions{};
  /// The centre of voxel (0, 0, 0).
  std::array<double, 3> origin{};
  /// Names of units: of the spacing, along the axes of the volume, and of steps and origin, along
  /// the coordinates of space.
  std::array<std::string, 3> axis_units{}, space_units{};
  /// The space of the coordinates; nothing if the file has only a spacing.
  Space space = Space::scanner;
  /// Whether the coordinates are left-handed. They become right-handed by the opposite x.
  bool is_left_handed = false;

  void set_unit(const std::string& name) {
    axis_units.fill(name);
    space_units.fill(name);
  }
};

/// Sets spacing and placement. Replaces an unknown unit by millimetres, an unusable spacing by 1
/// mm, unusable directions by the coordinate axes, an unusable origin by 0. Enlarges lengths below
/// a nanometre. Notes each replacement. options: spacing_mm overrides the file's.
///
/// The spacing gets the signs of the axes in right-handed coordinates. A surface that uses only the
/// spacing is therefore turned and moved against the placed one, never mirrored. A placement that
/// adds nothing to the spacing is dropped.
void set_place(VolumeInfo& info, const DeclaredPlace& declared, const VolumeOptions& options);

/// Returns the length of a unit in millimetres, or nothing if the name is not a length. Accepts
/// symbols and words in British or American spelling, singular or plural, in any case: "um",
/// "Microns".
std::optional<double> millimetres_in(std::string_view unit);

/// The scale and fill value of an array, declared by the attributes of NetCDF and xarray.
struct DeclaredValues {
  double slope = 1, intercept = 0;
  std::optional<double> fill{};       ///< marks samples without a value
  std::optional<bool> is_unsigned{};  ///< of whole numbers; nothing: as stored
};

/// number: returns the attribute of a name, if it is one number. sign: the text of the attribute
/// _Unsigned.
DeclaredValues declared_values(const std::function<std::optional<double>(const char*)>& number,
                               const std::string& sign);

/// Sets the type and the scale. Returns the fill value as a sample of this type. Limit: info has
/// the type of the stored samples.
std::optional<double> set_values(VolumeInfo& info, const std::string& file,
                                 const DeclaredValues& values);

}  // namespace discmc::command
