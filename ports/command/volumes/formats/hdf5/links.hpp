// What an HDF5 file leads to.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_LINKS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_LINKS_HPP

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

}  // namespace discmc::command

#endif
