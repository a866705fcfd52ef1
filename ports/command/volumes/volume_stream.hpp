// A file read from front to back, optionally decoded, and its slices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "byte_source.hpp"
#include "packing.hpp"
#include "volume_info.hpp"

namespace discmc::command {

/// The byte order of this machine.
bool is_native_big_endian();

/// Makes a source that decodes another one.
using Decoding = std::function<std::unique_ptr<ByteSource>(std::unique_ptr<ByteSource>)>;

/// Bytes of a named file, which can be peeked at before reading. Movable, not copyable.
class ByteStream {
 public:
  /// Throws like bytes_of_file().
  explicit ByteStream(const std::filesystem::path& file);
  ByteStream(std::filesystem::path file, std::unique_ptr<ByteSource> source);

  const std::filesystem::path& file() const { return file_; }

  /// Decodes all following bytes.
  void decode(const Decoding& decoding);

  /// Unpacks all following bytes of a packed file.
  void unpack(Packing packing);
  /// Returns how the file was packed, if it was.
  std::optional<Packing> packing() const { return packing_; }

  /// Whether the file can be opened only once.
  bool is_read_once() const { return is_read_once_; }

  /// Returns the next bytes without consuming them, fewer only at the end or at damage(). Memory
  /// grows with the existing bytes, not with `count`. Valid until the next call.
  std::string_view peek(std::size_t count);

  /// Returns the number of bytes read: fewer than requested only at the end or at damage().
  std::size_t read(void* bytes, std::size_t count);

  /// Returns the next line without its line feed and carriage return; nothing at the end. Throws if
  /// a line exceeds 1 MiB, which no header does.
  std::optional<std::string> read_line();

  /// Returns the number of bytes dropped: fewer than requested only at the end or at damage().
  std::uint64_t drop(std::uint64_t count);

  /// Drops bytes. Throws if there are fewer.
  void skip(std::uint64_t count);

  /// Drops lines, each up to its line feed. Throws if there are fewer.
  void skip_lines(std::uint64_t count);

  /// Returns the number of bytes read or dropped since the beginning or the last decode().
  std::uint64_t position() const { return position_; }

  /// As ByteSource.
  std::uint64_t max_left() const;
  std::optional<std::uint64_t> left() const;
  void check_end() { source_->check_end(); }
  std::string damage() const { return source_->damage(); }

 private:
  class Rest;

  std::size_t read_ahead(void* bytes, std::size_t count);
  std::size_t ahead() const { return ahead_.size() - ahead_begin_; }

  std::filesystem::path file_;
  std::unique_ptr<ByteSource> source_;
  std::string ahead_;  // peeked bytes, unread from ahead_begin_ on
  std::size_t ahead_begin_ = 0;
  std::uint64_t position_ = 0;
  std::optional<Packing> packing_;
  bool is_read_once_ = false;
};

/// Opens the bytes of a file, unpacked if it is packed as a whole.
ByteStream open_content(const std::filesystem::path& file);

/// Drops all but the last `bytes` bytes. Throws if the file is shorter, or has no known end.
void skip_to_end(ByteStream& stream, std::uint64_t bytes);

/// Returns a note about what follows the samples; empty if that does not matter.
using NoteOfRest = std::function<std::string(ByteStream&)>;

/// The reader of most formats: after the header, the samples of all slices follow in order.
class SliceStream final : public VolumeReader {
 public:
  /// The next sample of the stream is the first one of the first volume in the file. frame: the
  /// volume to read. note_of_rest: called after the last slice. Without it, bytes behind the last
  /// volume are noted, at once if the end of the file is known. Throws if the file cannot hold the
  /// first slice.
  SliceStream(VolumeInfo info, ByteStream stream, bool is_big_endian,
              std::optional<std::uint32_t> frame = {}, NoteOfRest note_of_rest = {});

  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override;
  void skip_slice() override;

 private:
  void end_slice(std::uint64_t bytes);
  void end();
  std::string note_of_bytes();
  [[noreturn]] void fail_in_slice(std::uint64_t missing) const;

  VolumeInfo info_;
  ByteStream stream_;
  bool is_big_endian_;
  bool is_last_volume_;
  NoteOfRest note_of_rest_;
  std::uint32_t slice_ = 0;
};

}  // namespace discmc::command
