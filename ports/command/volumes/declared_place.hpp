// The place of voxels as a file declares it, and as it is used: the one place for units,
// spacings, directions and origins.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "volume.hpp"

namespace discmc::command {

/// As the file has it, in its own units. What the file lacks stays empty.
struct DeclaredPlace {
  /// Distances of neighbouring voxels along x, y and z, negative where an axis runs backwards.
  std::array<std::optional<double>, 3> spacing{};
  /// The way to the next voxel along each axis. It counts more than the spacing.
  std::optional<Axes> steps{};
  /// The same as a direction, which the spacing makes as long as it is.
  std::optional<Axes> directions{};
  /// The centre of voxel (0, 0, 0).
  std::array<double, 3> origin{};
  /// Names of units: those of the spacing, along the axes of the volume, and those of steps and
  /// origin, along the coordinates of space.
  std::array<std::string, 3> axis_units{}, space_units{};
  /// What the coordinates of space are; nothing if the file has only a spacing.
  Space space = Space::scanner;
  /// Whether those coordinates are left-handed: right-handed ones have the opposite x.
  bool is_left_handed = false;

  void set_unit(const std::string& name) {
    axis_units.fill(name);
    space_units.fill(name);
  }
};

/// Takes spacing and placement. Replaces an unknown unit by millimetres, a missing or useless
/// spacing by 1 mm, useless directions by the coordinates, a useless origin by 0. Each replacement
/// has a note. options: whose spacing_mm counts more than the file's.
///
/// The spacing gets the signs of the axes in right-handed coordinates. A surface by the spacing
/// alone is turned and moved against the placed one, never mirrored. A placement that adds nothing
/// to the spacing is dropped.
void set_place(VolumeInfo& info, const DeclaredPlace& place, const VolumeOptions& options);

/// Returns how many millimetres a unit has; nothing if the name is that of no length. Symbols,
/// and words in British or American spelling, one or several, in any case: "um", "Microns".
std::optional<double> millimetres_in(std::string_view unit);

}  // namespace discmc::command
