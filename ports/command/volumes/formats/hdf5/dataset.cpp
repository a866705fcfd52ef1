#include "dataset.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

#ifdef DISCMC_WITHOUT_HDF5_PLUGINS
constexpr bool loads_plugins = false;
#else
constexpr bool loads_plugins = true;
#endif

// Silences the library, because discmc reports errors itself. The setting is per thread.
void disable_error_output() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  if (!loads_plugins) H5PLset_loading_state(0);
}

Hdf5Handle type_of(const Hdf5Handle& dataset) {
  return {H5Dget_type(dataset.id()), H5Tclose};
}

Hdf5Handle space_of(const Hdf5Handle& dataset) {
  return {H5Dget_space(dataset.id()), H5Sclose};
}

Hdf5Handle creation_of(const Hdf5Handle& dataset) {
  return {H5Dget_create_plist(dataset.id()), H5Pclose};
}

// Returns the type of whole numbers for truth values, which h5py stores as an enumeration.
Hdf5Handle number_type_of(const Hdf5Handle& dataset) {
  Hdf5Handle type = type_of(dataset);
  if (H5Tget_class(type.id()) == H5T_ENUM) type = {H5Tget_super(type.id()), H5Tclose};
  return type;
}

// Floating point of 16 bits is read as 32 bits.
std::optional<SampleType> sample_type_of(const Hdf5Handle& type) {
  const H5T_class_t kind = H5Tget_class(type.id());
  const std::size_t bytes = H5Tget_size(type.id());
  if (kind == H5T_FLOAT && bytes <= 4) return SampleType::f32;
  if (kind == H5T_FLOAT && bytes == 8) return SampleType::f64;
  if (kind == H5T_BITFIELD && bytes == 1) return SampleType::u8;
  if (kind != H5T_INTEGER) return std::nullopt;
  const bool has_sign = H5Tget_sign(type.id()) == H5T_SGN_2;
  switch (bytes) {
    case 1:
      return has_sign ? SampleType::i8 : SampleType::u8;
    case 2:
      return has_sign ? SampleType::i16 : SampleType::u16;
    case 4:
      return has_sign ? SampleType::i32 : SampleType::u32;
    case 8:
      return has_sign ? SampleType::i64 : SampleType::u64;
    default:
      return std::nullopt;
  }
}

// Returns a type of full width. The library's native type is smaller if a file uses fewer bits.
hid_t memory_type_of(SampleType type) {
  switch (type) {
    case SampleType::u8:
      return H5T_NATIVE_UINT8;
    case SampleType::i8:
      return H5T_NATIVE_INT8;
    case SampleType::u16:
      return H5T_NATIVE_UINT16;
    case SampleType::i16:
      return H5T_NATIVE_INT16;
    case SampleType::u32:
      return H5T_NATIVE_UINT32;
    case SampleType::i32:
      return H5T_NATIVE_INT32;
    case SampleType::u64:
      return H5T_NATIVE_UINT64;
    case SampleType::i64:
      return H5T_NATIVE_INT64;
    case SampleType::f32:
      return H5T_NATIVE_FLOAT;
    case SampleType::f64:
      return H5T_NATIVE_DOUBLE;
  }
  return H5I_INVALID_HID;
}

// Bits, which PyTables uses for truth values, convert to no other type.
hid_t memory_type_of(const Hdf5Handle& dataset, SampleType type) {
  return H5Tget_class(type_of(dataset).id()) == H5T_BITFIELD ? H5T_NATIVE_B8 : memory_type_of(type);
}

std::vector<hsize_t> sizes_of(const Hdf5Handle& dataset) {
  const Hdf5Handle space = space_of(dataset);
  std::vector<hsize_t> sizes(
      static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space.id()), 0)));
  H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
  return sizes;
}

Hdf5Description described(const Hdf5Handle& dataset, const std::string& path) {
  Hdf5Description found{path, {}, sample_type_of(number_type_of(dataset))};
  for (const hsize_t size : sizes_of(dataset))
    found.sizes.push_back(static_cast<std::int64_t>(std::min<hsize_t>(size, INT64_MAX)));
  return found;
}

std::uint64_t product(const std::vector<hsize_t>& factors) {
  return std::accumulate(factors.begin(), factors.end(), std::uint64_t{1}, std::multiplies<>());
}

// Returns a cache for all chunks that a region of this extent crosses. If chunks are as small as
// voxels, and too many to list, returns the library's own cache.
Hdf5Handle cache_of(const Hdf5Handle& dataset, const Hdf5Region& region) {
  Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  const Hdf5Handle creation = creation_of(dataset);
  if (H5Pget_layout(creation.id()) != H5D_CHUNKED) return access;
  std::vector<hsize_t> chunk(region.size());
  H5Pget_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data());
  std::vector<hsize_t> counts(chunk.size());
  for (std::size_t axis = 0; axis < counts.size(); ++axis)
    counts[axis] = (region[axis] + chunk[axis] - 1) / chunk[axis];
  const std::uint64_t chunks = product(counts);
  constexpr std::uint64_t max_chunks = std::uint64_t{1} << 20;
  if (chunks > max_chunks) return access;
  const std::uint64_t bytes = chunks * product(chunk) * H5Tget_size(type_of(dataset).id());
  constexpr std::size_t slots_per_chunk = 10;  // keeps collisions of chunks rare
  H5Pset_chunk_cache(access.id(), slots_per_chunk * chunks + 1, bytes, 1.0);
  return access;
}

}  // namespace

Hdf5Handle file_access() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
#if H5_VERSION_GE(1, 14, 4)
  H5Pset_relax_file_integrity_checks(access.id(), H5F_RFIC_UNUSUAL_NUM_UNUSED_NUMERIC_BITS);
#endif
  return access;
}

Hdf5Handle open_hdf5_file(const std::filesystem::path& file) {
  disable_error_output();
  register_hdf5_filters();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    fail(file, "there is no such file", "check the name");
  Hdf5Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, file_access().id()), H5Fclose);
  if (!opened)
    fail(file, "this is not an HDF5 file, or it is damaged, locked or unreadable",
         "copy or export it again; if a program is writing it, wait for the program");
  return opened;
}

std::optional<Hdf5Description> description_of(const Hdf5Handle& object, const std::string& path) {
  if (H5Iget_type(object.id()) != H5I_DATASET) return std::nullopt;
  Hdf5Description description = described(object, path);
  if (!description.type || description.sizes.size() < 2) return std::nullopt;
  return description;
}

Hdf5Dataset::Hdf5Dataset(const std::filesystem::path& name, const Hdf5Handle& file,
                         const std::string& path)
    : dataset_(H5Dopen2(file.id(), path.c_str(), H5P_DEFAULT), H5Dclose) {
  description_ = described(dataset_, path);
  const Hdf5Handle creation = creation_of(dataset_);
  const H5D_layout_t layout = H5Pget_layout(creation.id());
  is_chunked_ = layout == H5D_CHUNKED;
  is_virtual_ = layout == H5D_VIRTUAL || H5Pget_external_count(creation.id()) > 0;
  file_ = file_of(dataset_);
  if (const auto missing = missing_source(dataset_))
    fail(name, "it needs samples from the file " + shown(*missing) + ", which is missing",
         "copy it to the folder of " + shown(file_.filename().string()));
  storage_ = hdf5_filters(name, path, creation);
  if (storage_.empty())
    storage_ = is_virtual_ ? "virtual" : layout == H5D_CHUNKED ? "chunks" : "raw";
}

void Hdf5Dataset::expect(const Hdf5Handle& file, const Hdf5Region& region) {
  const Hdf5Handle access = cache_of(dataset_, region);
  // An open dataset keeps its old cache.
  dataset_ = Hdf5Handle(H5I_INVALID_HID, H5Dclose);
  dataset_ = {H5Dopen2(file.id(), description_.path.c_str(), access.id()), H5Dclose};
}

bool Hdf5Dataset::read(const Hdf5Region& first, const Hdf5Region& count, void* samples) const {
  disable_error_output();  // any thread may read slices
  const Hdf5Handle space = space_of(dataset_);
  const Hdf5Handle region(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                          H5Sclose);
  return H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(),
                             nullptr) >= 0 &&
         H5Dread(dataset_.id(), memory_type_of(dataset_, *description_.type), region.id(),
                 space.id(), H5P_DEFAULT, samples) >= 0;
}

}  // namespace discmc::command
