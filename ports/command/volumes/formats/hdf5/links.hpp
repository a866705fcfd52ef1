// What an HDF5 file leads to, and the files that a dataset lies in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "handle.hpp"

namespace discmc::command {

struct Hdf5Contents {
  std::vector<Hdf5Description> datasets;
  /// Links that lead nowhere, for people: "/entry/data/data_000002 to data_000002.h5".
  std::vector<std::string> dead_links;
};

/// Returns the datasets of numbers that have at least two dimensions, each by its first path, those
/// behind links to other files too.
Hdf5Contents hdf5_contents(const Hdf5Handle& file);

/// Returns the file that an object is in: another one than was opened where a link leads there.
std::filesystem::path file_of(const Hdf5Handle& dataset);

/// Returns the name of a missing file that a virtual dataset takes samples from. The library reads
/// its fill value for them, and reports no error. Patterns of names are not looked at.
std::optional<std::string> missing_source(const Hdf5Handle& dataset);

}  // namespace discmc::command
