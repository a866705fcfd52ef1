#include "chunks.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <system_error>

#include "volumes/byte_source.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

std::uint64_t bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(file, error);
  if (error) fail(file, "the chunk cannot be read", "check its permissions, or copy it again");
  return bytes;
}

// Limit: the file has this many bytes there.
ChunkBytes read_part(const std::filesystem::path& file, std::istream& in, std::uint64_t offset,
                     std::uint64_t bytes) {
  ChunkBytes part(bytes);
  in.clear();
  in.seekg(static_cast<std::streamoff>(offset));
  in.read(reinterpret_cast<char*>(part.data()), static_cast<std::streamsize>(bytes));
  if (in.gcount() != static_cast<std::streamsize>(bytes))
    fail(file, "the chunk cannot be read", "check its permissions, or copy it again");
  return part;
}

void turn(ChunkBytes& bytes, std::size_t size) {
  for (auto sample = bytes.begin(); sample != bytes.end();
       sample += static_cast<std::ptrdiff_t>(size))
    std::reverse(sample, sample + static_cast<std::ptrdiff_t>(size));
}

ChunkBytes widened(const ChunkBytes& halves) {
  ChunkBytes floats(2 * halves.size());
  for (std::size_t i = 0; i < halves.size() / 2; ++i) {
    std::uint16_t half = 0;
    std::memcpy(&half, &halves[2 * i], sizeof half);
    const float sample = float_of_half(half);
    std::memcpy(&floats[sizeof sample * i], &sample, sizeof sample);
  }
  return floats;
}

}  // namespace

// Returns the file of a chunk, or of the shard that contains it.
std::filesystem::path ZarrChunks::file_of(PerAxis chunk) const {
  std::string name;
  for (std::size_t axis = 0; axis < chunk.size(); ++axis) {
    if (array_.shard) chunk[axis] /= array_.shard->chunks[axis];
    name += (name.empty() ? "" : std::string(1, array_.separator)) + std::to_string(chunk[axis]);
  }
  return array_.folder / (array_.prefix + name);
}

void ZarrChunks::open_shard(const std::filesystem::path& file) {
  if (file == shard_name_) return;
  shard_name_ = file;
  shard_ = std::ifstream(file, std::ios::binary);
  places_.clear();
  std::error_code error;
  if (!std::filesystem::exists(file, error) && !error) return;
  const std::uint64_t file_bytes = bytes_of(file);
  std::uint64_t max_chunks = file_bytes / sizeof(ChunkLocation), count = 1;
  for (const std::uint64_t chunks : array_.shard->chunks) {
    if (chunks > max_chunks) fail(file, "the shard is shorter than its index", "copy it again");
    max_chunks /= chunks;
    count *= chunks;
  }
  const std::vector<ZarrCodec> codecs(array_.shard->has_index_checksum ? 1 : 0, ZarrCodec::crc32c);
  const std::uint64_t bytes = count * sizeof(ChunkLocation) + 4 * codecs.size();
  if (bytes > file_bytes) fail(file, "the shard is shorter than its index", "copy it again");
  const bool is_at_start = array_.shard->has_index_at_start;
  const ChunkBytes index =
      decoded(file, read_part(file, shard_, is_at_start ? 0 : file_bytes - bytes, bytes), codecs,
              count * sizeof(ChunkLocation));
  const std::uint64_t begin = is_at_start ? bytes : 0, end = begin + file_bytes - bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const ChunkLocation place{whole_of(&index[16 * i], 8, false),
                              whole_of(&index[16 * i + 8], 8, false)};
    const bool is_there = place.offset != UINT64_MAX || place.bytes != UINT64_MAX;
    if (is_there && (place.offset < begin || place.bytes > end || place.offset > end - place.bytes))
      fail(file, "a chunk lies outside the shard", "copy it again");
    places_.push_back(place);
  }
}

std::optional<ChunkBytes> ZarrChunks::packed(const std::filesystem::path& file,
                                             const PerAxis& chunk) {
  std::error_code error;
  if (!array_.shard) {
    if (!std::filesystem::exists(file, error) && !error) return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    return read_part(file, in, 0, bytes_of(file));
  }
  open_shard(file);
  if (places_.empty()) return std::nullopt;
  std::size_t number = 0;
  for (std::size_t axis = 0; axis < chunk.size(); ++axis)
    number = number * array_.shard->chunks[axis] + chunk[axis] % array_.shard->chunks[axis];
  const ChunkLocation& place = places_[number];
  if (place.offset == UINT64_MAX && place.bytes == UINT64_MAX) return std::nullopt;
  return read_part(file, shard_, place.offset, place.bytes);
}

std::optional<ChunkBytes> ZarrChunks::read(const PerAxis& chunk) {
  const std::filesystem::path file = file_of(chunk);
  auto bytes = packed(file, chunk);
  if (!bytes) return std::nullopt;
  ChunkBytes samples = decoded(file, std::move(*bytes), array_.codecs, array_.chunk_bytes());
  for (auto filter = array_.filters.rbegin(); filter != array_.filters.rend(); ++filter)
    undo(*filter, samples);
  const std::size_t size = array_.is_half ? 2 : sample_bytes(array_.type);
  if (array_.is_big_endian != is_native_big_endian()) turn(samples, size);
  return array_.is_half ? widened(samples) : std::move(samples);
}

}  // namespace discmc::command
