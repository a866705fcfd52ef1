// The metadata of an array of Zarr: its samples, and how its chunks are stored.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing.hpp"
#include "metadata.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

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
