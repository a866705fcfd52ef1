// The datasets of an HDF5 file, with their links and files. Dimension scales, as in NetCDF and
// xarray, and labels declare axes. In NeXus, a group names the datasets that are its axes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "handle.hpp"
#include "meshing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// The description of a dataset in the file.
struct Hdf5Description {
  std::string path;                 ///< "/exchange/data"
  std::vector<std::int64_t> sizes;  ///< as stored: x is the last one
  std::optional<SampleType> type;   ///< nothing unless elements are single numbers
};

/// Returns how to open files. HDF5 1.14.4 and newer refuse numbers that use less than half of their
/// bits (12 in 32), unless this is allowed.
Hdf5Handle file_access();

/// Returns the file, open for reading. Throws VolumeError.
Hdf5Handle open_hdf5_file(const std::filesystem::path& file);

/// Returns the description of an object, if it is a dataset of numbers with at least two
/// dimensions.
std::optional<Hdf5Description> description_of(const Hdf5Handle& object, const std::string& path);

/// One number per axis.
using Hdf5Region = std::vector<hsize_t>;

class Hdf5Dataset {
 public:
  /// Throws VolumeError if the dataset cannot be read. Limit: this path is a dataset of numbers.
  Hdf5Dataset(const std::filesystem::path& name, const Hdf5Handle& file, const std::string& path);

  const Hdf5Description& description() const { return description_; }
  /// Returns the storage for people: "raw", "chunks", or the filters that packed the dataset.
  const std::string& storage() const { return storage_; }
  bool is_chunked() const { return is_chunked_; }
  /// Whether the samples are in other files.
  bool is_virtual() const { return is_virtual_; }
  /// Returns the dataset's file, which differs from the opened one behind an external link.
  const std::filesystem::path& file() const { return file_; }
  /// Returns the dataset for access to its attributes.
  const Hdf5Handle& handle() const { return dataset_; }

  /// Caches all chunks that a region with this extent along each axis crosses. Each chunk is
  /// unpacked once if such regions are read in order. file: from which the dataset was opened.
  void expect(const Hdf5Handle& file, const Hdf5Region& region);

  /// Reads a region with this extent along each axis. Size: of samples, that of the region. Returns
  /// whether the region could be read.
  bool read(const Hdf5Region& first, const Hdf5Region& count, void* samples) const;

 private:
  Hdf5Description description_;
  Hdf5Handle dataset_;
  std::string storage_;
  bool is_chunked_ = false;
  bool is_virtual_ = false;
  std::filesystem::path file_;
};

struct Hdf5Contents {
  std::vector<Hdf5Description> datasets;
  /// Links without a target, for people: "/entry/data/data_000002 to data_000002.h5".
  std::vector<std::string> dead_links;
};

/// Returns the datasets of numbers with at least two dimensions, each by its first path, including
/// links to other files.
Hdf5Contents hdf5_contents(const Hdf5Handle& file);

/// Returns the file of an object, which differs from the opened one behind an external link.
std::filesystem::path file_of(const Hdf5Handle& dataset);

/// Returns the name of a missing source file of a virtual dataset. The library replaces its samples
/// by the fill value, and reports no error. Patterns of names are not checked.
std::optional<std::string> missing_source(const Hdf5Handle& dataset);

struct Hdf5Axis {
  std::string name;                 ///< or empty
  std::string unit;                 ///< of the coordinates
  std::vector<double> coordinates;  ///< one per index, or empty
};

/// Returns the axes in stored order.
std::vector<Hdf5Axis> axes_of(const Hdf5Handle& dataset, std::size_t count);

/// Returns the numbers of an attribute of a dataset or group. Returns none if it has no numbers, or
/// too many.
std::vector<double> numbers_of(const Hdf5Handle& object, const char* attribute);

/// Likewise returns the numbers of a dataset.
std::vector<double> numbers_in(const Hdf5Handle& dataset);

/// Returns the text of an attribute, or nothing.
std::string text_of(const Hdf5Handle& object, const char* attribute);

}  // namespace discmc::command
