#include "writer.hpp"

#include <cstring>
#include <limits>
#include <stdexcept>

namespace discmc::host {

void require_triangles(const Mesh& mesh, const std::string& format) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) != 3) throw std::invalid_argument(format + " takes triangles only");
}

void Writer::bytes(std::uint64_t value, int count) {
  char little_endian[8];
  for (int i = 0; i < count; ++i) little_endian[i] = static_cast<char>(value >> (8 * i) & 0xFF);
  text({little_endian, static_cast<std::size_t>(count)});
}

void Writer::point(const Point& point) {
  char little_endian[12];
  char* next = little_endian;
  for (const double coordinate : point) {
    const auto value = static_cast<float>(coordinate);
    static_assert(std::numeric_limits<float>::is_iec559 && sizeof value == 4);
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 4; ++i) *next++ = static_cast<char>(bits >> (8 * i) & 0xFF);
  }
  text({little_endian, sizeof little_endian});
}

void Writer::finish() {
  flush();
  out_.flush();
  if (!out_) throw std::runtime_error("writing failed");
}

void Writer::flush() {
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  if (!out_) throw std::runtime_error("writing failed");
  buffer_.clear();
}

}  // namespace discmc::host
