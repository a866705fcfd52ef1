// Bytes of a file in order, inflated on the way where asked, and slices cut from them.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_STREAM_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_STREAM_HPP

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "volume.hpp"

namespace discmc::host {

/// The byte order of this machine.
bool is_native_big_endian();

/// Reads a regular file from front to back. Movable, not copyable.
class ByteStream {
 public:
  /// Throws VolumeError when there is no such file, or when it is a folder, pipe or device.
  explicit ByteStream(const std::filesystem::path& file);
  ByteStream(ByteStream&&) noexcept;
  ByteStream& operator=(ByteStream&&) noexcept;
  ~ByteStream();

  const std::filesystem::path& file() const { return file_; }
  std::uint64_t file_bytes() const { return file_bytes_; }

  /// Goes to a byte of the file. Before start_inflate() only. Throws past the end.
  void seek(std::uint64_t offset);

  /// Goes past the next lines, each up to its line feed. Before start_inflate() only. Throws when
  /// there are fewer.
  void skip_lines(std::uint64_t count);

  /// From here on the file is a gzip or zlib stream, and what is read is its content.
  void start_inflate();

  /// Drops bytes (of the content, once inflating). Throws when there are fewer.
  void skip(std::uint64_t count);

  /// Returns the number of bytes read: fewer than asked only at the end or at damage().
  std::size_t read(void* bytes, std::size_t count);

  /// Returns an upper bound of what read() can still give. Units: bytes.
  std::uint64_t most_left() const;

  /// Returns what is wrong with the compressed data, empty if nothing so far.
  const std::string& damage() const;

  bool inflating() const { return inflater_ != nullptr; }

 private:
  struct Inflater;

  std::filesystem::path file_;
  std::ifstream in_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t position_ = 0;
  std::unique_ptr<Inflater> inflater_;
};

/// The reader of every format: its header is done, the samples of all slices follow in order.
class SliceStream final : public VolumeReader {
 public:
  /// The stream stands at the first sample. Throws when the first slice cannot be there.
  SliceStream(VolumeInfo info, ByteStream stream, bool big_endian);

  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override;

 private:
  [[noreturn]] void fail_in_slice(std::uint64_t missing) const;

  VolumeInfo info_;
  ByteStream stream_;
  bool big_endian_;
  std::uint32_t slice_ = 0;
};

}  // namespace discmc::host

#endif
