// The datasets of an HDF5 file, the links to them, and the files that they lie in. Axes are
// declared by dimension scales, as NetCDF and xarray write them, and labels. In NeXus a group names
// the datasets that are its axes.
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
  std::vector<std::int64_t> sizes;  ///< as they are stored: x is the last one
  std::optional<SampleType> type;   ///< nothing where it holds no single numbers
};

/// How files are opened. HDF5 1.14.4 and newer refuse numbers of less than half the bits that they
/// have room for (12 in 32) unless asked not to.
Hdf5Handle file_access();

/// Returns the file, open for reading. Throws VolumeError.
Hdf5Handle open_hdf5_file(const std::filesystem::path& file);

/// Returns what an object is, if it is a dataset of numbers with at least two dimensions.
std::optional<Hdf5Description> description_of(const Hdf5Handle& object, const std::string& path);

/// A number an axis.
using Hdf5Region = std::vector<hsize_t>;

class Hdf5Dataset {
 public:
  /// Throws VolumeError where it cannot be read. Limit: there is a dataset of this path and of
  /// numbers.
  Hdf5Dataset(const std::filesystem::path& name, const Hdf5Handle& file, const std::string& path);

  const Hdf5Description& description() const { return description_; }
  /// How it is stored, for people: "raw", "chunks", or the filters that have packed it.
  const std::string& storage() const { return storage_; }
  bool is_chunked() const { return is_chunked_; }
  /// Whether its samples are in other files.
  bool is_virtual() const { return is_virtual_; }
  /// That it is in, which is another one behind an external link.
  const std::filesystem::path& file() const { return file_; }
  /// For its attributes.
  const Hdf5Handle& handle() const { return dataset_; }

  /// Keeps all chunks that a region with this extent along each axis crosses. Each chunk is
  /// unpacked once if such regions are read in their order. file: that it was opened from.
  void expect(const Hdf5Handle& file, const Hdf5Region& region);

  /// Reads a region with this extent along each axis. Size: its samples of the type. Returns
  /// whether they could be read.
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
