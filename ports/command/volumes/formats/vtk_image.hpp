// VTK's declaration of an image, in XML and in HDF5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "volumes/declared_place.hpp"

namespace discmc::command {

/// The name of the array that marks samples shared with another piece.
constexpr std::string_view vtk_ghosts = "vtkGhostType";

/// The indexes of the first and the last point along x, y and z.
using VtkExtent = std::array<std::int64_t, 6>;

/// Parses an extent. name: of the field. Throws VolumeError if the text is invalid.
VtkExtent vtk_extent(const std::filesystem::path& file, std::string_view name,
                     const std::vector<double>& numbers);

/// Returns the number of points of an extent along an axis, or of cells between them; below 1 if
/// empty.
std::int64_t vtk_size(const VtkExtent& extent, std::size_t axis, bool is_of_cells);

/// Returns the place of the first voxel of an extent, at a point or in a cell. Numbers are as
/// stored, or empty; each row of a direction matrix is a coordinate. Throws VolumeError unless
/// there are 3, 3 and 9.
DeclaredPlace declared_place(const std::filesystem::path& file, const std::vector<double>& spacing,
                             const std::vector<double>& origin,
                             const std::vector<double>& direction, const VtkExtent& extent,
                             bool is_of_cells);

}  // namespace discmc::command
