#include "gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <stdexcept>

#include "files/write_failure.hpp"

namespace discmc::command {

Gzip::Gzip(std::streambuf& out) : out_(out), stream_(std::make_unique<z_stream>()) {
  constexpr int window_bits = 15, with_gzip_header = 16, memory_level = 9;
  if (deflateInit2(stream_.get(), Z_BEST_COMPRESSION, Z_DEFLATED, window_bits + with_gzip_header,
                   memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
}

Gzip::~Gzip() {
  deflateEnd(stream_.get());
}

std::streamsize Gzip::xsputn(const char* bytes, std::streamsize count) {
  std::streamsize taken = 0;
  while (taken < count) {
    const std::streamsize part =
        std::min<std::streamsize>(count - taken, std::numeric_limits<int>::max());
    stream_->next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes + taken));
    stream_->avail_in = static_cast<uInt>(part);
    if (!deflate(Z_NO_FLUSH)) return taken;
    taken += part;
  }
  return taken;
}

bool Gzip::deflate(int flush) {
  std::array<char, 1 << 16> buffer;
  do {
    stream_->next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream_->avail_out = static_cast<uInt>(buffer.size());
    ::deflate(stream_.get(), flush);
    const auto count = static_cast<std::streamsize>(buffer.size() - stream_->avail_out);
    has_failed_ = has_failed_ || out_.sputn(buffer.data(), count) != count;
  } while (stream_->avail_out == 0);
  return !has_failed_;
}

void Gzip::finish() {
  if (!deflate(Z_FINISH)) throw std::runtime_error(write_failure());
}

}  // namespace discmc::command
