// The metadata of a folder of Zarr, https://zarr-specs.readthedocs.io: version 2 in .zgroup,
// .zarray and .zattrs, version 3 in zarr.json. An array has samples in chunks, which are stored in
// some way.
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

/// Returns a member of an object, or null where there is none.
const Json& member(const Json& object, const char* name);

/// Returns a text, or nothing where it is none.
std::string text_of(const Json& value);

/// Return the numbers of an array. Throw VolumeError where it is another thing. file, name: for it.
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
  Json attributes{};  ///< of programs, such as OME
};

/// Throws VolumeError where the folder is none, or has no readable metadata.
ZarrNode read_zarr_node(const std::filesystem::path& folder);

/// A number an axis of an array, the slowest first.
using PerAxis = std::vector<std::uint64_t>;

/// A file of several chunks.
struct ZarrShard {
  PerAxis chunks;  ///< along each axis
  bool has_index_at_start = false;
  bool has_index_checksum = false;
};

enum class ZarrCodec : std::uint8_t { gzip, zlib, zstd, blosc, crc32c };

/// A filter of numcodecs that samples went through before they were packed.
struct ZarrFilter {
  std::size_t shuffled_bytes = 0;   ///< of an element whose bytes are apart; otherwise 0
  std::optional<SampleType> delta;  ///< of samples that are differences to those before
};

struct ZarrDescription {
  std::filesystem::path folder;
  std::vector<std::int64_t> sizes;
  SampleType type = SampleType::u8;
  bool is_half = false;  ///< stored as floating point of 16 bits, and read as that of 32
  bool is_big_endian = false;
  std::array<unsigned char, 8> fill{};  ///< a sample of `type`, for chunks that are not there
  std::vector<std::string> axis_names;  ///< one an axis, or none

  PerAxis chunk;                    ///< sizes
  std::vector<std::size_t> order;   ///< axes as a chunk has them, the slowest first
  std::vector<ZarrCodec> codecs;    ///< in the order in which they were applied
  std::vector<ZarrFilter> filters;  ///< before those, in their order
  std::optional<ZarrShard> shard;
  std::string prefix;    ///< of the names of files
  char separator = '.';  ///< in them

  /// Units: bytes of a chunk as it was before it was packed.
  std::size_t chunk_bytes() const;
};

/// Throws VolumeError if the array has no numbers, is packed in a way that is not read, or has none
/// of its chunks.
ZarrDescription described(const ZarrNode& node);

/// Returns the codec of a name in version 2 or 3; nothing where it is not read.
std::optional<ZarrCodec> zarr_codec(std::string_view name);

using ChunkBytes = std::vector<unsigned char>;

/// Undoes a filter.
void undo(const ZarrFilter& filter, ChunkBytes& bytes);

/// Undoes codecs, of which the first was applied first. chunk: for errors. bytes: of the chunk
/// before. Throws VolumeError if it has fewer, or is damaged.
ChunkBytes decoded(const std::filesystem::path& chunk, ChunkBytes packed,
                   const std::vector<ZarrCodec>& codecs, std::size_t bytes);

}  // namespace discmc::command
