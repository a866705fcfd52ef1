// How the samples of a chunk were packed.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_ZARR_CODECS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_ZARR_CODECS_HPP

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace discmc::command {

enum class ZarrCodec : std::uint8_t { gzip, zlib, zstd, blosc, crc32c };

/// Returns the codec of a name in version 2 or 3; nothing where it is not read.
std::optional<ZarrCodec> zarr_codec(std::string_view name);

using ChunkBytes = std::vector<unsigned char>;

/// Undoes codecs, of which the first was applied first. chunk: for errors. bytes: of the chunk
/// before. Throws VolumeError if it has fewer, or is damaged.
ChunkBytes decoded(const std::filesystem::path& chunk, ChunkBytes packed,
                   const std::vector<ZarrCodec>& codecs, std::size_t bytes);

}  // namespace discmc::command

#endif
