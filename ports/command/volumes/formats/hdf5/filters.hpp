// Filters of HDF5 that its library does not have.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_FILTERS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_FILTERS_HPP

#include <filesystem>
#include <string>

#include "handle.hpp"

namespace discmc::command {

/// Gives the library what unpacks LZF, and Blosc where discmc was built with it.
void register_hdf5_filters();

/// Returns the names of the filters that packed a dataset. Throws VolumeError where one of them is
/// not here. name: of the file, array: of the dataset in it, for the remedy.
std::string hdf5_filters(const std::filesystem::path& name, const std::string& array,
                         const Hdf5Handle& creation);

}  // namespace discmc::command

#endif
