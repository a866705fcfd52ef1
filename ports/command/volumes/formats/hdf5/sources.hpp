// The files that a dataset of HDF5 lies in.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_SOURCES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_SOURCES_HPP

#include <filesystem>
#include <optional>
#include <string>

#include "handle.hpp"

namespace discmc::command {

/// Returns the file that an object is in: another one than was opened where a link leads there.
std::filesystem::path file_of(const Hdf5Handle& dataset);

/// Returns the name of a missing file that a virtual dataset takes samples from. The library reads
/// its fill value for them, and reports no error. Patterns of names are not looked at.
std::optional<std::string> missing_source(const Hdf5Handle& dataset);

}  // namespace discmc::command

#endif
