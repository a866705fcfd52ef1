// What VTK declares of an image, in XML and in HDF5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "volumes/declared_place.hpp"

namespace discmc::command {

/// The array that marks samples which another piece of the image has, too.
constexpr std::string_view vtk_ghosts = "vtkGhostType";

/// The numbers of the first and the last point along x, y and z.
using VtkExtent = std::array<std::int64_t, 6>;

/// Returns the numbers of an extent. name: of the field. Throws VolumeError when they are none.
VtkExtent vtk_extent(const std::filesystem::path& file, std::string_view name,
                     const std::vector<double>& numbers);

/// Returns how many points an extent has along an axis, or cells between them; less than 1 if none.
std::int64_t vtk_size(const VtkExtent& extent, std::size_t axis, bool is_of_cells);

/// Returns the place of the first voxel of an extent: of points, or of cells between them. All
/// numbers are as stored, or none; a direction has a row of its matrix per coordinate. Throws
/// VolumeError when they are not 3, 3 and 9.
DeclaredPlace declared_place(const std::filesystem::path& file, const std::vector<double>& spacing,
                             const std::vector<double>& origin,
                             const std::vector<double>& direction, const VtkExtent& extent,
                             bool is_of_cells);

}  // namespace discmc::command
