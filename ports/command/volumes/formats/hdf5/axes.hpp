// What a dataset of HDF5 declares of its axes: dimension scales, as NetCDF and xarray write them,
// and labels. NeXus names datasets of the group as axes.
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"

namespace discmc::command {

struct Hdf5Axis {
  std::string name;                 ///< empty if it has none
  std::string unit;                 ///< of the coordinates
  std::vector<double> coordinates;  ///< one for each place, or none
};

/// Returns the axes as they are stored.
std::vector<Hdf5Axis> axes_of(const Hdf5Handle& dataset, std::size_t count);

/// Returns the numbers of an attribute of a dataset or group; none where it has no numbers, or too
/// many.
std::vector<double> numbers_of(const Hdf5Handle& object, const char* attribute);

/// Returns the text of an attribute, or nothing.
std::string text_of(const Hdf5Handle& object, const char* attribute);

}  // namespace discmc::command
