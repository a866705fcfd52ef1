#include "volume_stream.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "volume_error.hpp"

namespace discmc::command {
namespace {

// Converts samples from the file's byte order to the machine's.
template <std::size_t size>
void swap_samples(unsigned char* bytes, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i, bytes += size) std::reverse(bytes, bytes + size);
}

void order_samples(unsigned char* bytes, std::uint64_t count, std::size_t size,
                   bool is_big_endian) {
  if (is_big_endian == is_native_big_endian()) return;
  if (size == 2) swap_samples<2>(bytes, count);
  if (size == 4) swap_samples<4>(bytes, count);
  if (size == 8) swap_samples<8>(bytes, count);
}

constexpr const char* note_of_surplus =
    " bytes after the samples are left out; check the sizes and the header";

}  // namespace

bool is_native_big_endian() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

// The bytes that a stream had not returned when a decoder replaced it.
class ByteStream::Rest final : public ByteSource {
 public:
  explicit Rest(ByteStream stream) : stream_(std::move(stream)) {}
  std::size_t read(void* bytes, std::size_t count) override { return stream_.read(bytes, count); }
  std::uint64_t max_left() const override { return stream_.max_left(); }
  void check_end() override { stream_.check_end(); }
  std::string damage() const override { return stream_.damage(); }

 private:
  ByteStream stream_;
};

ByteStream::ByteStream(const std::filesystem::path& file)
    : ByteStream(file == "-" ? "standard input" : file, bytes_of_file(file)) {
  is_read_once_ = command::is_read_once(file);
}

ByteStream::ByteStream(std::filesystem::path file, std::unique_ptr<ByteSource> source)
    : file_(std::move(file)), source_(std::move(source)) {}

void ByteStream::decode(const Decoding& decoding) {
  std::filesystem::path file = file_;
  const bool is_read_once = is_read_once_;
  const auto packing = packing_;
  auto rest = std::make_unique<Rest>(std::move(*this));
  *this = ByteStream(std::move(file), decoding(std::move(rest)));
  packing_ = packing;
  is_read_once_ = is_read_once;
}

void ByteStream::unpack(Packing packing) {
  const std::filesystem::path file = file_;
  decode([&](auto in) { return unpacked(std::move(in), packing, file); });
  packing_ = packing;
}

std::string_view ByteStream::peek(std::size_t count) {
  constexpr std::size_t max_at_once = 1U << 20;
  ahead_.erase(0, ahead_begin_);
  ahead_begin_ = 0;
  while (ahead_.size() < count) {
    const std::size_t before = ahead_.size();
    const std::size_t wanted = std::min(count - before, max_at_once);
    ahead_.resize(before + wanted);
    const std::size_t got = source_->read(ahead_.data() + before, wanted);
    ahead_.resize(before + got);
    if (got < wanted) break;
  }
  return std::string_view(ahead_).substr(0, count);
}

std::size_t ByteStream::read_ahead(void* bytes, std::size_t count) {
  const std::size_t ahead_bytes = std::min(count, ahead());
  if (bytes != nullptr) std::memcpy(bytes, ahead_.data() + ahead_begin_, ahead_bytes);
  ahead_begin_ += ahead_bytes;
  position_ += ahead_bytes;
  if (ahead() == 0) {
    std::string().swap(ahead_);
    ahead_begin_ = 0;
  }
  return ahead_bytes;
}

std::size_t ByteStream::read(void* bytes, std::size_t count) {
  const std::size_t ahead_bytes = read_ahead(bytes, count);
  if (ahead_bytes == count) return count;
  const std::size_t got =
      source_->read(static_cast<char*>(bytes) + ahead_bytes, count - ahead_bytes);
  position_ += got;
  return ahead_bytes + got;
}

std::optional<std::string> ByteStream::read_line() {
  constexpr std::size_t max_header_bytes = 1U << 20;
  constexpr std::size_t step = 256;
  std::size_t available = ahead();
  std::size_t end = ahead_.find('\n', ahead_begin_);
  while (end == std::string::npos) {
    if (position_ + available > max_header_bytes)
      fail(file_,
           "the header has no end in its first " + std::to_string(position_ + available) + " bytes",
           "check that the name has the right extension");
    const std::size_t searched = available;
    available = peek(available + step).size();
    end = ahead_.find('\n', searched);
    if (available == searched) break;
  }
  if (available == 0) return std::nullopt;
  std::string line(std::min(end, ahead_.size()) - ahead_begin_, '\0');
  read_ahead(line.data(), line.size());
  read_ahead(nullptr, 1);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

std::uint64_t ByteStream::drop(std::uint64_t count) {
  const std::size_t ahead_bytes = read_ahead(nullptr, std::min<std::uint64_t>(count, ahead()));
  const std::uint64_t skipped = source_->skip(count - ahead_bytes);
  position_ += skipped;
  return ahead_bytes + skipped;
}

void ByteStream::skip(std::uint64_t count) {
  const std::uint64_t missing = count - drop(count);
  if (missing == 0) return;
  fail(file_,
       "of " + std::to_string(count) + " bytes to skip " + std::to_string(missing) +
           " are missing" + (damage().empty() ? "" : ": " + damage()),
       "copy the file again or correct its header");
}

void ByteStream::skip_lines(std::uint64_t count) {
  for (std::uint64_t line = 0; line < count; ++line) {
    char byte = 0;
    do {
      if (ahead() == 0) peek(4096);
      if (read_ahead(&byte, 1) == 0)
        fail(file_,
             "of " + std::to_string(count) + " lines to skip only " + std::to_string(line) +
                 " exist",
             "correct the line skip in the header");
    } while (byte != '\n');
  }
}

std::uint64_t ByteStream::max_left() const {
  const std::uint64_t source_left = source_->max_left();
  return source_left > ByteSource::unbounded - ahead() ? ByteSource::unbounded
                                                       : source_left + ahead();
}

std::optional<std::uint64_t> ByteStream::left() const {
  const auto left = source_->left();
  return left ? std::optional(*left + ahead()) : std::nullopt;
}

ByteStream open_content(const std::filesystem::path& file) {
  ByteStream stream(file);
  if (const auto packing = packing_of(stream.peek(packing_magic_bytes))) stream.unpack(*packing);
  return stream;
}

void skip_to_end(ByteStream& stream, std::uint64_t bytes) {
  const auto left = stream.left();
  if (!left)
    fail(stream.file(), "the data is at the end of the file, and the end of this input is unknown",
         "store it in an uncompressed file");
  if (bytes > *left)
    fail(stream.file(),
         "the last " + std::to_string(bytes) + " bytes are data, but the file has only " +
             std::to_string(*left),
         copy_or_export);
  stream.skip(*left - bytes);
}

SliceStream::SliceStream(VolumeInfo info, ByteStream stream, bool is_big_endian,
                         std::optional<std::uint32_t> frame, NoteOfRest note_of_rest)
    : info_(std::move(info)),
      stream_(std::move(stream)),
      is_big_endian_(is_big_endian),
      is_last_volume_(frame.value_or(0) + 1 == info_.frames),
      note_of_rest_(std::move(note_of_rest)) {
  if (stream_.packing()) info_.format += ", " + std::string(name(*stream_.packing()));
  const auto left = stream_.left();
  if (!note_of_rest_ && left && *left > bytes_of_all(info_))
    note(info_, std::to_string(*left - bytes_of_all(info_)) + note_of_surplus);
  stream_.skip(volume_bytes(info_) * frame.value_or(0));
  // This bounds the caller's slice buffer by the file, whatever its header declares.
  const std::uint64_t slice = info_.slice_bytes();
  std::uint64_t max_left = stream_.max_left();
  if (max_left == ByteSource::unbounded)
    max_left = stream_.peek(static_cast<std::size_t>(slice)).size();
  if (max_left < slice) fail_in_slice(slice - max_left);
}

void SliceStream::read_slice(void* samples) {
  require_slice_left(stream_.file(), slice_, info_.dims[2]);
  const std::uint64_t bytes = info_.slice_bytes();
  end_slice(stream_.read(samples, static_cast<std::size_t>(bytes)));
  const std::size_t size = sample_bytes(info_.type);
  order_samples(static_cast<unsigned char*>(samples), bytes / size, size, is_big_endian_);
}

void SliceStream::skip_slice() {
  require_slice_left(stream_.file(), slice_, info_.dims[2]);
  end_slice(stream_.drop(info_.slice_bytes()));
}

// bytes: number read of the slice.
void SliceStream::end_slice(std::uint64_t bytes) {
  if (bytes < info_.slice_bytes()) fail_in_slice(info_.slice_bytes() - bytes);
  if (slice_ + 1 == info_.dims[2]) end();
  ++slice_;
}

void SliceStream::end() {
  const std::string rest = note_of_rest_ ? note_of_rest_(stream_) : note_of_bytes();
  if (!rest.empty()) return note(info_, rest);
  stream_.check_end();
  if (!stream_.damage().empty()) fail_in_slice(0);
}

// Notes extra bytes, if the size was unknown when the file was opened.
std::string SliceStream::note_of_bytes() {
  const bool has_more = is_last_volume_ && !stream_.left() && !stream_.peek(1).empty();
  return has_more ? std::string("more") + note_of_surplus : std::string();
}

void SliceStream::fail_in_slice(std::uint64_t missing) const {
  std::string what = "slice " + std::to_string(slice_) + " (the first is 0) of " +
                     std::to_string(info_.dims[2]) + ": ";
  if (missing > 0) what += std::to_string(missing) + " bytes of it are missing";
  const std::string damage = stream_.damage();
  if (missing > 0 && !damage.empty()) what += "; ";
  fail(stream_.file(), what + damage, copy_or_export);
}

}  // namespace discmc::command
