// Sources of bytes, read once from front to back: files, standard input, pipes, and decoders.
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

/// Returns the whole number that bytes store.
template <class Byte>
std::uint64_t whole_of(const Byte* bytes, std::size_t count, bool is_big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[is_big_endian ? i : count - 1 - i]);
  return value;
}

/// Returns false if the path is missing or cannot be read.
bool is_file(const std::filesystem::path& path);

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

  /// Returns an upper bound of the bytes that read() can still return.
  virtual std::uint64_t max_left() const = 0;

  /// Returns the number of bytes that read() can still return, if known.
  virtual std::optional<std::uint64_t> left() const { return std::nullopt; }

  /// Reads what follows the needed bytes, such as a checksum.
  virtual void check_end() {}

  /// Returns what is wrong with the bytes; empty if they are valid so far.
  virtual std::string damage() const { return {}; }
};

/// A source that produces its bytes in parts.
class PartwiseSource : public ByteSource {
 public:
  std::size_t read(void* bytes, std::size_t count) final;

 protected:
  /// Returns the unread bytes of the current part.
  std::size_t left_in_part() const { return left_; }
  void set_part(const void* bytes, std::size_t count) {
    part_ = static_cast<const char*>(bytes);
    left_ = count;
  }

 private:
  /// Produces the next part. Returns false, or produces an empty part, only at the end or at
  /// damage().
  virtual bool next_part() = 0;

  const char* part_ = nullptr;
  std::size_t left_ = 0;
};

/// Whether the name means standard input ("-") or a pipe, which can be opened only once.
bool is_read_once(const std::filesystem::path& file);

/// Opens a file; "-" is standard input. Throws VolumeError if the file does not exist, or is a
/// folder or a block device.
std::unique_ptr<ByteSource> bytes_of_file(const std::filesystem::path& file);

std::unique_ptr<ByteSource> bytes_in_memory(std::vector<unsigned char> bytes);

/// Inflates gzip members or a zlib stream.
std::unique_ptr<ByteSource> inflated(std::unique_ptr<ByteSource> in);

/// Inflates this many zlib streams, one after another.
std::unique_ptr<ByteSource> inflated_blocks(std::unique_ptr<ByteSource> in, std::uint64_t count);

/// Decodes base64 text up to the first '<'. Each part is padded on its own.
std::unique_ptr<ByteSource> base64_decoded(std::unique_ptr<ByteSource> in);

/// Decodes an IEEE 754 number of 16 bits, for which C++17 has no type. The result is exact.
float float_of_half(std::uint16_t half);

/// Converts 16-bit to 32-bit floating point in native byte order.
std::unique_ptr<ByteSource> floats_of_halves(std::unique_ptr<ByteSource> in, bool is_big_endian);

/// Parses numbers between blanks or commas, up to the first '<', into samples in native byte order.
std::unique_ptr<ByteSource> samples_of_text(std::unique_ptr<ByteSource> in, SampleType type);

}  // namespace discmc::command
