// The metadata of a Zarr folder, https://zarr-specs.readthedocs.io: .zgroup, .zarray and .zattrs in
// version 2, zarr.json in version 3. They describe the chunks of an array and their storage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

using Json = nlohmann::json;

/// Returns a member of an object, or null.
const Json& member(const Json& object, const char* name);

/// Returns the text of a value, or nothing for other values.
std::string text_of(const Json& value);

/// Return the numbers of an array. Throw VolumeError for other values. file, name: for errors.
std::vector<std::int64_t> integers_of(const std::filesystem::path& file, const char* name,
                                      const Json& value);
std::vector<double> reals_of(const std::filesystem::path& file, const char* name,
                             const Json& value);

/// A group or an array.
struct ZarrNode {
  std::filesystem::path folder;
  std::filesystem::path file;  ///< for errors
  bool is_array = false;
  Json array{};       ///< of an array: .zarray, or zarr.json
  Json attributes{};  ///< user attributes, such as OME
};

/// Throws VolumeError if the path is not a folder with readable metadata.
ZarrNode read_zarr_node(const std::filesystem::path& folder);

/// One number per axis of an array, the slowest first.
using PerAxis = std::vector<std::uint64_t>;

/// A file with several chunks.
struct ZarrShard {
  PerAxis chunks;  ///< along each axis
  bool has_index_at_start = false;
  bool has_index_checksum = false;
};

enum class ZarrCodec : std::uint8_t { gzip, zlib, zstd, blosc, crc32c };

/// A filter of numcodecs, applied to samples before they were packed.
struct ZarrFilter {
  std::size_t shuffled_bytes = 0;   ///< size of an element whose bytes are apart; else 0
  std::optional<SampleType> delta;  ///< type of samples stored as differences
};

struct ZarrDescription {
  std::filesystem::path folder;
  std::vector<std::int64_t> sizes;
  SampleType type = SampleType::u8;
  bool is_half = false;  ///< whether 16-bit floating point is read as 32 bits
  bool is_big_endian = false;
  std::array<unsigned char, 8> fill{};  ///< a sample of `type`, for missing chunks
  std::vector<std::string> axis_names;  ///< one per axis, or empty

  PerAxis chunk;                    ///< sizes
  std::vector<std::size_t> order;   ///< order of axes in a chunk, the slowest first
  std::vector<ZarrCodec> codecs;    ///< in the order of their application
  std::vector<ZarrFilter> filters;  ///< before the codecs, in order
  std::optional<ZarrShard> shard;
  std::string prefix;    ///< of chunk names
  char separator = '.';  ///< of chunk names

  /// Returns the unpacked size of a chunk. Units: bytes.
  std::size_t chunk_bytes() const;
};

/// Throws VolumeError if the array has no numbers, an unsupported packing, or no chunks.
ZarrDescription described(const ZarrNode& node);

/// Returns the codec by its name in version 2 or 3, or nothing if it is unsupported.
std::optional<ZarrCodec> zarr_codec(std::string_view name);

using ChunkBytes = std::vector<unsigned char>;

/// Undoes a filter.
void undo(const ZarrFilter& filter, ChunkBytes& bytes);

/// Undoes codecs; the first was applied first. chunk: for errors. bytes: the unpacked size. Throws
/// VolumeError if the chunk has fewer bytes, or is damaged.
ChunkBytes decoded(const std::filesystem::path& chunk, ChunkBytes packed,
                   const std::vector<ZarrCodec>& codecs, std::size_t bytes);

}  // namespace discmc::command
