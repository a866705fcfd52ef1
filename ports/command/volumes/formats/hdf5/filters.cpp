#include "handle.hpp"

#include <cstring>
#include <optional>
#include <string_view>

#include "volumes/array_name.hpp"
#include "volumes/volume_error.hpp"

#ifdef DISCMC_WITH_BLOSC
#include <blosc.h>
#endif

namespace discmc::command {
namespace {

// The number that the HDF Group has registered.
constexpr H5Z_filter_t lzf_filter = 32000;
constexpr H5Z_filter_t blosc_filter = 32001;

// Memory that the library frees.
struct Unpacked {
  unsigned char* bytes = nullptr;
  std::size_t count = 0;
};

Unpacked room_for(std::size_t count) {
  constexpr bool is_cleared = false;
  return {static_cast<unsigned char*>(H5allocate_memory(count, is_cleared)), count};
}

// Returns the number of bytes, or 0 after a failure, as HDF5 requires.
std::size_t return_unpacked(const Unpacked& unpacked, std::size_t* room, void** buffer) {
  if (unpacked.bytes == nullptr) return 0;
  H5free_memory(*buffer);
  *buffer = unpacked.bytes;
  *room = unpacked.count;
  return unpacked.count;
}

// Parses LZF, http://oldhome.schmorp.de/marc/liblzf.html: a byte n below 32 precedes n + 1 literal
// bytes. Other bytes repeat earlier ones: their upper three bits encode the count, their lower five
// and the next byte the distance. Calls take(bytes, count) for literal bytes and repeat(distance,
// count). Returns whether the data is valid.
template <class Take, class Repeat>
bool read_lzf(const unsigned char* in, std::size_t bytes, Take take, Repeat repeat) {
  const unsigned char* const end = in + bytes;
  while (in < end) {
    const unsigned control = *in++;
    if (control < 32) {
      const std::size_t count = control + 1;
      if (static_cast<std::size_t>(end - in) < count) return false;
      take(in, count);
      in += count;
      continue;
    }
    std::size_t count = control >> 5;
    if (count == 7) {
      if (in == end) return false;
      count += *in++;
    }
    if (in == end || !repeat((std::size_t{control & 31} << 8 | *in++) + 1, count + 2)) return false;
  }
  return true;
}

// Computes the unpacked size before allocating memory.
std::optional<std::size_t> unpacked_lzf_bytes(const unsigned char* in, std::size_t bytes) {
  std::size_t count = 0;
  const bool is_whole = read_lzf(
      in, bytes, [&](const unsigned char*, std::size_t more) { count += more; },
      [&](std::size_t distance, std::size_t more) {
        const bool is_inside = distance <= count;
        count += more;
        return is_inside;
      });
  return is_whole && count > 0 ? std::optional(count) : std::nullopt;
}

std::size_t unpack_lzf(unsigned flags, std::size_t, const unsigned*, std::size_t bytes,
                       std::size_t* room, void** buffer) {
  if ((flags & H5Z_FLAG_REVERSE) == 0) return 0;
  const auto* const in = static_cast<const unsigned char*>(*buffer);
  const auto count = unpacked_lzf_bytes(in, bytes);
  if (!count) return 0;
  const Unpacked unpacked = room_for(*count);
  if (unpacked.bytes == nullptr) return 0;
  unsigned char* out = unpacked.bytes;
  read_lzf(
      in, bytes,
      [&out](const unsigned char* from, std::size_t more) {
        std::memcpy(out, from, more);
        out += more;
      },
      // Copies byte by byte, because the source may overlap its copy.
      [&out](std::size_t distance, std::size_t more) {
        for (; more > 0; --more, ++out) *out = *(out - distance);
        return true;
      });
  return return_unpacked(unpacked, room, buffer);
}

#ifdef DISCMC_WITH_BLOSC
std::size_t unpack_blosc(unsigned flags, std::size_t, const unsigned*, std::size_t bytes,
                         std::size_t* room, void** buffer) {
  std::size_t count = 0;
  if ((flags & H5Z_FLAG_REVERSE) == 0 || blosc_cbuffer_validate(*buffer, bytes, &count) < 0)
    return 0;
  const Unpacked unpacked = room_for(count);
  constexpr int threads = 1;
  if (unpacked.bytes != nullptr &&
      blosc_decompress_ctx(*buffer, unpacked.bytes, count, threads) == static_cast<int>(count))
    return return_unpacked(unpacked, room, buffer);
  H5free_memory(unpacked.bytes);
  return 0;
}
#endif

void register_filter(H5Z_filter_t id, const char* name, H5Z_func_t unpack) {
  // The filter cannot pack, but must report this. Otherwise the tests could not make datasets with
  // it.
  const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, id, 1, 1, name, nullptr, nullptr, unpack};
  H5Zregister(&filter);
}

// Quotes a name for a command, unless a shell or Python could interpret it.
std::string quoted(const std::string& name, const char* otherwise) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-";
  return name.find_first_not_of(harmless) == std::string::npos ? name : otherwise;
}

// Python packages can unpack all other filters.
[[noreturn]] void fail_filter(const std::filesystem::path& name, const std::string& array,
                              H5Z_filter_t filter) {
  fail(name,
       "its samples are packed by the filter " + std::to_string(filter) +
           " of HDF5, which is not installed",
       "unpack them in Python, with: pip install h5py hdf5plugin; python3 -c \"import h5py, "
       "hdf5plugin; h5py.File('unpacked.h5', 'w')['volume'] = h5py.File('" +
           quoted(array_name(name).file.string(), "FILE") + "')['" + quoted(array, "NAME") +
           "'][()]\"");
}

}  // namespace

void register_hdf5_filters() {
  if (H5Zfilter_avail(lzf_filter) <= 0) register_filter(lzf_filter, "lzf", unpack_lzf);
#ifdef DISCMC_WITH_BLOSC
  if (H5Zfilter_avail(blosc_filter) <= 0) register_filter(blosc_filter, "blosc", unpack_blosc);
#endif
}

std::string hdf5_filters(const std::filesystem::path& name, const std::string& array,
                         const Hdf5Handle& creation) {
  std::string names;
  for (int i = 0; i < H5Pget_nfilters(creation.id()); ++i) {
    char text[64] = {};
    unsigned flags = 0;
    std::size_t no_values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation.id(), static_cast<unsigned>(i), &flags,
                                               &no_values, nullptr, sizeof text, text, nullptr);
    if (H5Zfilter_avail(filter) <= 0) fail_filter(name, array, filter);
    const std::string called = filter == H5Z_FILTER_DEFLATE ? "gzip" : text;
    names += (names.empty() ? "" : ", ") + called;
  }
  return names;
}

}  // namespace discmc::command
