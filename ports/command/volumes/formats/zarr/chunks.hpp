// The chunks of a Zarr array: each is a file, or a part of a shard.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "description.hpp"

namespace discmc::command {

class ZarrChunks {
 public:
  explicit ZarrChunks(ZarrDescription array) : array_(std::move(array)) {}

  const ZarrDescription& array() const { return array_; }

  /// Returns the samples of a chunk, in native byte order and the order of array()'s axes; nothing
  /// if it is missing. Throws VolumeError if the chunk is damaged.
  std::optional<ChunkBytes> read(const PerAxis& chunk);

 private:
  // The location of a chunk in a shard.
  struct ChunkLocation {
    std::uint64_t offset, bytes;
  };

  std::filesystem::path file_of(PerAxis chunk) const;
  std::optional<ChunkBytes> packed(const std::filesystem::path& file, const PerAxis& chunk);
  void open_shard(const std::filesystem::path& file);

  ZarrDescription array_;
  std::filesystem::path shard_name_;
  std::ifstream shard_;
  std::vector<ChunkLocation> places_;
};

}  // namespace discmc::command
