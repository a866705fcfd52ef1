// How the samples of a chunk were packed.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_ZARR_CODECS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_ZARR_CODECS_HPP

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "meshing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

enum class ZarrCodec : std::uint8_t { gzip, zlib, zstd, blosc, crc32c };

/// Returns the codec of a name in version 2 or 3; nothing where it is not read.
std::optional<ZarrCodec> zarr_codec(std::string_view name);

using ChunkBytes = std::vector<unsigned char>;

/// A filter of numcodecs that samples went through before they were packed.
struct ZarrFilter {
  std::size_t shuffled_bytes = 0;   ///< of an element whose bytes are apart; otherwise 0
  std::optional<SampleType> delta;  ///< of samples that are differences to those before
};

/// Undoes a filter.
void undo(const ZarrFilter& filter, ChunkBytes& bytes);

/// Undoes codecs, of which the first was applied first. chunk: for errors. bytes: of the chunk
/// before. Throws VolumeError if it has fewer, or is damaged.
ChunkBytes decoded(const std::filesystem::path& chunk, ChunkBytes packed,
                   const std::vector<ZarrCodec>& codecs, std::size_t bytes);

}  // namespace discmc::command

#endif
