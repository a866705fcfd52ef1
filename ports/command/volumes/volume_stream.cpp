#include "volume_stream.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <system_error>
#include <utility>

#include "volume_format.hpp"

namespace discmc::host {
namespace {

// Deflate cannot expand a byte of its stream to more than this.
constexpr std::uint64_t most_inflation = 1032;

// Samples arrive in the file's byte order and leave in the machine's.
template <std::size_t size>
void swap_samples(unsigned char* bytes, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i, bytes += size) std::reverse(bytes, bytes + size);
}

void order_samples(unsigned char* bytes, std::uint64_t count, std::size_t size, bool big_endian) {
  if (big_endian == is_native_big_endian()) return;
  if (size == 2) swap_samples<2>(bytes, count);
  if (size == 4) swap_samples<4>(bytes, count);
  if (size == 8) swap_samples<8>(bytes, count);
}

}  // namespace

bool is_native_big_endian() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

struct ByteStream::Inflater {
  z_stream state{};
  std::array<unsigned char, 65536> input;
  std::string damage;
  bool ended = false;

  Inflater() {
    constexpr int largest_window_either_wrapper = 15 + 32;
    if (inflateInit2(&state, largest_window_either_wrapper) != Z_OK)
      throw VolumeError("zlib does not start; the memory may be exhausted");
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&state); }

  void refill(std::ifstream& in) {
    if (state.avail_in != 0) return;
    in.read(reinterpret_cast<char*>(input.data()), static_cast<std::streamsize>(input.size()));
    state.next_in = input.data();
    state.avail_in = static_cast<uInt>(in.gcount());
  }

  // gzip files may be concatenated; anything else after the end is padding.
  void end_member(std::ifstream& in) {
    refill(in);
    constexpr unsigned char gzip_magic = 0x1f;
    ended = state.avail_in == 0 || *state.next_in != gzip_magic || inflateReset(&state) != Z_OK;
  }

  std::size_t read(std::ifstream& in, unsigned char* bytes, std::size_t count) {
    std::size_t done = 0;
    while (done < count && !ended && damage.empty()) {
      refill(in);
      constexpr std::size_t most_at_once = 1U << 30;
      const auto room = static_cast<uInt>(std::min(count - done, most_at_once));
      state.next_out = bytes + done;
      state.avail_out = room;
      const int status = inflate(&state, Z_NO_FLUSH);
      done += room - state.avail_out;
      if (status == Z_STREAM_END) {
        end_member(in);
      } else if (status == Z_BUF_ERROR) {
        damage = "the compressed data ends early";
      } else if (status != Z_OK) {
        damage = "the compressed data is damaged";
        if (state.msg != nullptr) damage += std::string(" (") + state.msg + ")";
      }
    }
    return done;
  }
};

ByteStream::ByteStream(const std::filesystem::path& file) : file_(file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) fail(file, "there is no such file", "check the name");
  if (!std::filesystem::is_regular_file(status))
    fail(file, "this is no regular file", "store the volume in a file first");
  const auto bytes = std::filesystem::file_size(file, error);
  if (!error) in_.open(file, std::ios::binary);
  if (error || !in_) fail(file, "the file cannot be opened", "check its permissions");
  file_bytes_ = bytes;
}

ByteStream::ByteStream(ByteStream&&) noexcept = default;
ByteStream& ByteStream::operator=(ByteStream&&) noexcept = default;
ByteStream::~ByteStream() = default;

void ByteStream::seek(std::uint64_t offset) {
  if (offset > file_bytes_)
    fail(file_,
         "the data should begin at byte " + std::to_string(offset) + " but the file has only " +
             std::to_string(file_bytes_),
         "copy the file again or correct its header");
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(offset));
  position_ = offset;
}

void ByteStream::skip_lines(std::uint64_t count) {
  for (std::uint64_t line = 0; line < count; ++line) {
    int byte = 0;
    do {
      byte = in_.rdbuf()->sbumpc();
      if (byte == std::ifstream::traits_type::eof())
        fail(file_,
             "of " + std::to_string(count) + " lines to skip only " + std::to_string(line) +
                 " are there",
             "correct the line skip in the header");
      ++position_;
    } while (byte != '\n');
  }
}

void ByteStream::start_inflate() {
  inflater_ = std::make_unique<Inflater>();
}

void ByteStream::skip(std::uint64_t count) {
  if (!inflating()) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    seek(position_ + std::min(count, most - position_));
    return;
  }
  std::array<unsigned char, 4096> dropped;
  for (std::uint64_t left = count; left > 0;) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, dropped.size()));
    const std::size_t got = read(dropped.data(), wanted);
    left -= got;
    if (got < wanted)
      fail(file_,
           "of " + std::to_string(count) + " bytes to skip " + std::to_string(left) +
               " are not there" + (damage().empty() ? "" : ": " + damage()),
           "copy the file again or correct the byte skip in the header");
  }
}

std::size_t ByteStream::read(void* bytes, std::size_t count) {
  if (inflating()) return inflater_->read(in_, static_cast<unsigned char*>(bytes), count);
  in_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
  const auto got = static_cast<std::size_t>(in_.gcount());
  position_ += got;
  return got;
}

std::uint64_t ByteStream::most_left() const {
  const std::uint64_t left = file_bytes_ - std::min(position_, file_bytes_);
  return inflating() ? left * most_inflation : left;
}

const std::string& ByteStream::damage() const {
  static const std::string none;
  return inflating() ? inflater_->damage : none;
}

SliceStream::SliceStream(VolumeInfo info, ByteStream stream, bool big_endian)
    : info_(std::move(info)), stream_(std::move(stream)), big_endian_(big_endian) {
  // The caller's slice buffer is thus bounded by the file, whatever its header claims.
  const std::uint64_t most = stream_.most_left();
  if (most < info_.slice_bytes()) fail_in_slice(info_.slice_bytes() - most);
}

void SliceStream::read_slice(void* samples) {
  if (slice_ == info_.dims[2])
    fail(stream_.file(), "all " + std::to_string(slice_) + " slices have been read",
         "open the volume again");
  const std::uint64_t bytes = info_.slice_bytes();
  const std::size_t got = stream_.read(samples, static_cast<std::size_t>(bytes));
  if (got < bytes) fail_in_slice(bytes - got);
  if (slice_ + 1 == info_.dims[2] && stream_.inflating()) {
    // One byte more makes zlib compare the checksum.
    unsigned char beyond = 0;
    stream_.read(&beyond, 1);
    if (!stream_.damage().empty()) fail_in_slice(0);
  }
  const std::size_t size = sample_bytes(info_.type);
  order_samples(static_cast<unsigned char*>(samples), bytes / size, size, big_endian_);
  ++slice_;
}

void SliceStream::fail_in_slice(std::uint64_t missing) const {
  std::string what = "slice " + std::to_string(slice_) + " (the first is 0) of " +
                     std::to_string(info_.dims[2]) + ": ";
  if (missing > 0) what += std::to_string(missing) + " bytes of it are missing";
  if (missing > 0 && !stream_.damage().empty()) what += "; ";
  fail(stream_.file(), what + stream_.damage(), "copy or export the file again");
}

}  // namespace discmc::host
