#include "description.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "volumes/packing.hpp"
#include "volumes/volume_error.hpp"

#ifdef DISCMC_WITH_BLOSC
#include <blosc.h>
#endif

namespace discmc::command {
namespace {

constexpr std::size_t checksum_bytes = 4;

[[noreturn]] void fail_damaged(const std::filesystem::path& chunk, const std::string& what) {
  fail(chunk, "the chunk is damaged" + (what.empty() ? what : ": " + what), "copy the file again");
}

// Castagnoli's polynomial, from RFC 3720.
std::uint32_t crc32c(const ChunkBytes& bytes, std::size_t count) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (std::size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78U : 0);
  }
  return ~crc;
}

void check_and_remove_checksum(const std::filesystem::path& chunk, ChunkBytes& bytes) {
  if (bytes.size() < checksum_bytes) fail_damaged(chunk, "it is incomplete");
  const std::size_t count = bytes.size() - checksum_bytes;
  if (whole_of(&bytes[count], checksum_bytes, false) != crc32c(bytes, count))
    fail_damaged(chunk, "its checksum is wrong");
  bytes.resize(count);
}

ChunkBytes unpacked_bytes(const std::filesystem::path& chunk, ChunkBytes packed, Packing packing,
                          std::size_t bytes) {
  const auto source = unpacked(bytes_in_memory(std::move(packed)), packing, chunk);
  ChunkBytes result(bytes);
  const std::size_t got = source->read(result.data(), bytes);
  unsigned char beyond = 0;
  const bool has_more = source->read(&beyond, 1) > 0;
  if (got < bytes || has_more || !source->damage().empty()) fail_damaged(chunk, source->damage());
  return result;
}

#ifdef DISCMC_WITH_BLOSC
ChunkBytes unblosced(const std::filesystem::path& chunk, const ChunkBytes& packed,
                     std::size_t bytes) {
  std::size_t unpacked_bytes = 0;
  if (blosc_cbuffer_validate(packed.data(), packed.size(), &unpacked_bytes) < 0 ||
      unpacked_bytes != bytes)
    fail_damaged(chunk, "it is not packed by Blosc");
  ChunkBytes result(bytes);
  constexpr int threads = 1;
  if (blosc_decompress_ctx(packed.data(), result.data(), bytes, threads) != static_cast<int>(bytes))
    fail_damaged(chunk, "Blosc cannot unpack it");
  return result;
}
#else
ChunkBytes unblosced(const std::filesystem::path& chunk, const ChunkBytes&, std::size_t) {
  fail(chunk, "this is packed by Blosc, and discmc was built without libblosc",
       "install libblosc-dev and build again");
}
#endif

}  // namespace

std::optional<ZarrCodec> zarr_codec(std::string_view name) {
  // zarr-python 3 uses this prefix for the codecs of version 2.
  constexpr std::string_view prefix = "numcodecs.";
  if (name.substr(0, prefix.size()) == prefix) name.remove_prefix(prefix.size());
  constexpr std::pair<std::string_view, ZarrCodec> names[] = {{"gzip", ZarrCodec::gzip},
                                                              {"zlib", ZarrCodec::zlib},
                                                              {"zstd", ZarrCodec::zstd},
                                                              {"blosc", ZarrCodec::blosc},
                                                              {"crc32c", ZarrCodec::crc32c}};
  for (const auto& [called, codec] : names)
    if (called == name) return codec;
  return std::nullopt;
}

void undo(const ZarrFilter& filter, ChunkBytes& bytes) {
  if (const std::size_t size = filter.shuffled_bytes; size > 1) {
    const ChunkBytes apart = bytes;
    const std::size_t count = bytes.size() / size;  // the remaining bytes stay unchanged
    for (std::size_t i = 0; i < count * size; ++i) bytes[i] = apart[i % size * count + i / size];
  }
  if (!filter.delta) return;
  with_sample_type(*filter.delta, [&](auto sample) {
    using Sample = decltype(sample);
    Sample sum{};
    for (std::size_t at = 0; at + sizeof sample <= bytes.size(); at += sizeof sample) {
      std::memcpy(&sample, &bytes[at], sizeof sample);
      if constexpr (std::is_integral_v<Sample>) {
        using Whole = std::make_unsigned_t<Sample>;
        sum = static_cast<Sample>(
            static_cast<Whole>(static_cast<Whole>(sum) + static_cast<Whole>(sample)));
      } else {
        sum += sample;
      }
      std::memcpy(&bytes[at], &sum, sizeof sum);
    }
  });
}

ChunkBytes decoded(const std::filesystem::path& chunk, ChunkBytes packed,
                   const std::vector<ZarrCodec>& codecs, std::size_t bytes) {
  // Limits the decoded size per byte, because a chunk may declare any size.
  constexpr std::size_t max_of_a_byte = 65536;
  if (bytes / max_of_a_byte > packed.size())
    fail(chunk,
         "a chunk of " + std::to_string(bytes) + " bytes cannot be in " +
             std::to_string(packed.size()),
         "copy the file again");
  for (std::size_t i = codecs.size(); i-- > 0;) {
    // Earlier codecs may have added checksums to the samples.
    const auto checksums = std::count(
        codecs.begin(), codecs.begin() + static_cast<std::ptrdiff_t>(i), ZarrCodec::crc32c);
    const std::size_t before = bytes + checksum_bytes * static_cast<std::size_t>(checksums);
    switch (codecs[i]) {
      case ZarrCodec::crc32c:
        check_and_remove_checksum(chunk, packed);
        break;
      case ZarrCodec::blosc:
        packed = unblosced(chunk, packed, before);
        break;
      case ZarrCodec::zstd:
        packed = unpacked_bytes(chunk, std::move(packed), Packing::zstd, before);
        break;
      case ZarrCodec::gzip:
      case ZarrCodec::zlib:
        packed = unpacked_bytes(chunk, std::move(packed), Packing::gzip, before);
        break;
    }
  }
  if (packed.size() != bytes) fail_damaged(chunk, "its size differs from other chunks");
  return packed;
}

}  // namespace discmc::command
