// What the writers of mesh files share: numbers as text and as bytes, and what a file says of
// itself. Internal to the writers.
#ifndef DISCMC_COMMAND_MESH_FILES_WRITER_HPP
#define DISCMC_COMMAND_MESH_FILES_WRITER_HPP

#include <charconv>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

#include "meshes/mesh.hpp"

namespace discmc::host {

/// What every file says of itself, in a comment or where its format has a place for such text; the
/// frame as 3D Slicer reads and writes it.
constexpr std::string_view header_text(const Mesh& mesh) {
  switch (mesh.frame) {
    case Frame::none:
      break;
    case Frame::lps:
      return "discmc, millimetres, SPACE=LPS";
    case Frame::ras:
      return "discmc, millimetres, SPACE=RAS";
  }
  return "discmc, millimetres";
}

/// Throws std::invalid_argument where a face is no triangle. format: its name.
void require_triangles(const Mesh& mesh, const std::string& format);

/// The shortest decimal that reads back as the same value.
template <typename Number>
std::string decimal(Number value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// Collects small writes, and makes a failing stream a std::runtime_error.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) { buffer_.reserve(full + 64); }

  void text(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= full) flush();
  }

  template <typename Number>
  void decimal(Number value) {
    text(host::decimal(value));
  }

  /// The lowest bytes of a value, little endian.
  void bytes(std::uint64_t value, int count);

  /// Three 32-bit floats, little endian.
  void point(const Point& point);

  /// Call last; what is still collected is lost otherwise.
  void finish();

 private:
  static constexpr std::size_t full = 1 << 16;

  void flush();

  std::ostream& out_;
  std::string buffer_;
};

}  // namespace discmc::host

#endif
