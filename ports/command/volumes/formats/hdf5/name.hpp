// What names an HDF5 file, and a dataset in it.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_NAME_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_NAME_HPP

#include <filesystem>
#include <string>

namespace discmc::command {

/// scan.h5:/exchange/data taken apart.
struct Hdf5Name {
  std::filesystem::path file;
  std::string dataset;  ///< "/exchange/data"; empty where none is named
};
Hdf5Name hdf5_name(const std::filesystem::path& name);

/// Whether a file is named as HDF5 files are, or a dataset in it is.
bool has_hdf5_name(const std::filesystem::path& name);

}  // namespace discmc::command

#endif
