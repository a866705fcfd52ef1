// Bytes in order, once: of a file, of standard input, of a pipe, and what decoders make of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// The whole number that bytes store.
template <class Byte>
std::uint64_t whole_of(const Byte* bytes, std::size_t count, bool is_big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[is_big_endian ? i : count - 1 - i]);
  return value;
}

class ByteSource {
 public:
  /// For max_left(): no bound is known.
  static constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Returns the number of bytes read: fewer than asked only at the end or at damage().
  virtual std::size_t read(void* bytes, std::size_t count) = 0;

  /// Returns the number of bytes skipped: fewer than asked as for read().
  virtual std::uint64_t skip(std::uint64_t count);

  /// Returns an upper bound of what read() can still give. Units: bytes.
  virtual std::uint64_t max_left() const = 0;

  /// Returns what read() can still give, where that is known. Units: bytes.
  virtual std::optional<std::uint64_t> left() const { return std::nullopt; }

  /// Reads the end, such as a checksum, after all needed bytes.
  virtual void check_end() {}

  /// Returns what is wrong with the bytes, empty if nothing so far.
  virtual std::string damage() const { return {}; }
};

/// A source that makes some of its bytes at a time.
class PartwiseSource : public ByteSource {
 public:
  std::size_t read(void* bytes, std::size_t count) final;

 protected:
  /// Units: bytes of the part that are still to be read.
  std::size_t left_in_part() const { return left_; }
  void set_part(const void* bytes, std::size_t count) {
    part_ = static_cast<const char*>(bytes);
    left_ = count;
  }

 private:
  /// Makes the next part. Returns false, or a part of no bytes, only at the end or at damage().
  virtual bool next_part() = 0;

  const char* part_ = nullptr;
  std::size_t left_ = 0;
};

/// Whether the name is that of standard input ("-") or of a pipe: what can be opened once only.
bool is_read_once(const std::filesystem::path& file);

/// "-" is standard input. Throws VolumeError when there is no such file, or when it is a folder or
/// a block device.
std::unique_ptr<ByteSource> bytes_of_file(const std::filesystem::path& file);

std::unique_ptr<ByteSource> bytes_in_memory(std::vector<unsigned char> bytes);

/// The content of gzip members or of a zlib stream.
std::unique_ptr<ByteSource> inflated(std::unique_ptr<ByteSource> in);

/// The content of this many zlib streams, one after the other.
std::unique_ptr<ByteSource> inflated_blocks(std::unique_ptr<ByteSource> in, std::uint64_t count);

/// The bytes of text in base64, in parts that are each filled up, up to the first '<'.
std::unique_ptr<ByteSource> base64_decoded(std::unique_ptr<ByteSource> in);

/// The number that 16 bits of IEEE 754 encode, which C++17 has no type for. It is exact.
float float_of_half(std::uint16_t half);

/// Floating point of 32 bits in native byte order, from that of 16 bits.
std::unique_ptr<ByteSource> floats_of_halves(std::unique_ptr<ByteSource> in, bool is_big_endian);

/// Samples in native byte order from numbers as text, between blanks or commas, up to the first
/// '<'.
std::unique_ptr<ByteSource> samples_of_text(std::unique_ptr<ByteSource> in, SampleType type);

}  // namespace discmc::command
