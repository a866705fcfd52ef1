// The metadata of an array of Zarr: its samples, and how its chunks are stored.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_ZARR_DESCRIPTION_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_ZARR_DESCRIPTION_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "codecs.hpp"
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

struct ZarrDescription {
  std::filesystem::path folder;
  std::vector<std::int64_t> sizes;
  SampleType type = SampleType::u8;
  bool is_half = false;  ///< stored as floating point of 16 bits, and read as that of 32
  bool big_endian = false;
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

}  // namespace discmc::command

#endif
