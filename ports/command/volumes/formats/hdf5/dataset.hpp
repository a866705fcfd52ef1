// The datasets of an HDF5 file, and one of them, slice by slice.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_DATASET_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_HDF5_DATASET_HPP

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "handle.hpp"
#include "volumes/sample_type.hpp"

namespace discmc::command {

/// What a dataset holds, as the file says.
struct Hdf5Description {
  std::string path;                 ///< "/exchange/data"
  std::vector<std::int64_t> sizes;  ///< as they are stored: x is the last one
  std::optional<SampleType> type;   ///< nothing where it holds no single numbers
};

/// How files are opened: HDF5 1.14.4 and newer refuse numbers of less than half the bits that they
/// have room for, such as 12 bits in 32, unless they are asked not to.
Hdf5Handle file_access();

/// Returns the file, open for reading. Throws VolumeError.
Hdf5Handle open_hdf5_file(const std::filesystem::path& file);

/// Returns the datasets of numbers that have at least two dimensions, by their paths.
std::vector<Hdf5Description> hdf5_datasets(const Hdf5Handle& file);

/// A dataset. Its chunks, where it has any, are unpacked once if slices are read in their order:
/// the library keeps all those that a slice goes through.
class Hdf5Dataset {
 public:
  /// Throws VolumeError where there is none of this path, or something else.
  Hdf5Dataset(const std::filesystem::path& name, const Hdf5Handle& file, const std::string& path);

  const Hdf5Description& description() const { return description_; }
  /// How it is stored, for people: "raw", "chunks", or the filters that have packed it.
  const std::string& storage() const { return storage_; }
  /// Whether its samples are in other files.
  bool is_virtual() const { return is_virtual_; }
  /// That it is in, which is another one behind an external link.
  const std::filesystem::path& file() const { return file_; }
  /// Its attribute `element_size_um`, along z, y and x, if there is one. Units: micrometres.
  std::optional<std::array<double, 3>> element_size_um() const;

  /// Reads slice z of the volume `frame` of those in it. Size: width x height samples of the type.
  /// Returns whether they could be read.
  bool read_slice(std::uint64_t frame, std::uint32_t z, void* samples) const;

 private:
  Hdf5Description description_;
  Hdf5Handle dataset_;
  std::string storage_;
  bool is_virtual_ = false;
  std::filesystem::path file_;
};

}  // namespace discmc::command

#endif
