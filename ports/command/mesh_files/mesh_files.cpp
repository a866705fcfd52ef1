#include "mesh_files.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace discmc::host {
namespace {

// Collects small writes, and makes a failing stream an exception.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) { buffer_.reserve(full + 64); }

  void text(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= full) flush();
  }

  // The shortest decimal that reads back as the same value.
  template <typename Number>
  void decimal(Number value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text({digits, static_cast<std::size_t>(end - digits)});
  }

  void bytes(std::uint32_t value, int count) {
    char little_endian[4];
    for (int i = 0; i < count; ++i) little_endian[i] = static_cast<char>(value >> (8 * i) & 0xFF);
    text({little_endian, static_cast<std::size_t>(count)});
  }

  void point(const Point& point) {
    for (const double coordinate : point) {
      const auto value = static_cast<float>(coordinate);
      static_assert(std::numeric_limits<float>::is_iec559 && sizeof value == 4);
      std::uint32_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      bytes(bits, 4);
    }
  }

  void finish() {
    flush();
    out_.flush();
    if (!out_) throw std::runtime_error("writing failed");
  }

 private:
  static constexpr std::size_t full = 1 << 16;

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (!out_) throw std::runtime_error("writing failed");
    buffer_.clear();
  }

  std::ostream& out_;
  std::string buffer_;
};

std::size_t largest_face(const Mesh& mesh) {
  std::size_t largest = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    largest = std::max(largest, mesh.face_size(face));
  return largest;
}

// A line of OBJ.
void write_point(const char* key, const Point& point, Writer& writer) {
  writer.text(key);
  for (const double coordinate : point) {
    writer.text(" ");
    writer.decimal(coordinate);
  }
  writer.text("\n");
}

void write_vertex(const Vertex& vertex, Writer& writer) {
  writer.text("[");
  writer.decimal(vertex.x);
  writer.text(",");
  writer.decimal(vertex.y);
  writer.text(",");
  writer.decimal(vertex.z);
  writer.text("]");
}

void write_ring(const Ring& ring, Writer& writer) {
  writer.text("[");
  const char* separator = "";
  for (const Vertex& vertex : corners_of(ring)) {
    writer.text(separator);
    write_vertex(vertex, writer);
    separator = ",";
  }
  writer.text("]");
}

}  // namespace

void write_obj(const Mesh& mesh, std::ostream& out) {
  Writer writer(out);
  writer.text("# discmc, millimetres\n");
  for (const Point& vertex : mesh.vertices_mm) write_point("v", vertex, writer);
  for (const Point& normal : mesh.normals) write_point("vn", normal, writer);
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    writer.text("f");
    for (std::size_t i = 0; i < mesh.face_size(face); ++i) {
      const std::uint64_t number = std::uint64_t{mesh.face(face)[i]} + 1;
      writer.text(" ");
      writer.decimal(number);
      if (mesh.normals.empty()) continue;
      writer.text("//");
      writer.decimal(number);
    }
    writer.text("\n");
  }
  writer.finish();
}

void write_ply(const Mesh& mesh, std::ostream& out) {
  Writer writer(out);
  // Every reader takes lists counted by a byte, so wider counts only where they must be.
  const bool byte_counts = largest_face(mesh) <= 0xFF;
  writer.text("ply\nformat binary_little_endian 1.0\ncomment discmc, millimetres\nelement vertex ");
  writer.decimal(mesh.vertices_mm.size());
  writer.text("\nproperty float x\nproperty float y\nproperty float z");
  if (!mesh.normals.empty())
    writer.text("\nproperty float nx\nproperty float ny\nproperty float nz");
  writer.text("\nelement face ");
  writer.decimal(mesh.face_count());
  writer.text(byte_counts ? "\nproperty list uchar int" : "\nproperty list uint int");
  writer.text(" vertex_indices\nend_header\n");
  for (std::size_t vertex = 0; vertex < mesh.vertices_mm.size(); ++vertex) {
    writer.point(mesh.vertices_mm[vertex]);
    if (!mesh.normals.empty()) writer.point(mesh.normals[vertex]);
  }
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    writer.bytes(static_cast<std::uint32_t>(mesh.face_size(face)), byte_counts ? 1 : 4);
    for (std::size_t i = 0; i < mesh.face_size(face); ++i) writer.bytes(mesh.face(face)[i], 4);
  }
  writer.finish();
}

void write_stl(const Mesh& mesh, std::ostream& out) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) != 3) throw std::invalid_argument("STL takes triangles only");
  if (mesh.face_count() > 0xFFFFFFFFu) throw std::invalid_argument("too many triangles for STL");
  Writer writer(out);
  std::string header = "binary STL, discmc, millimetres";  // "solid" would announce text
  header.resize(80, ' ');
  writer.text(header);
  writer.bytes(static_cast<std::uint32_t>(mesh.face_count()), 4);
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    writer.point(outward_normal(mesh.incidences[face], mesh.spacing_mm));
    for (std::size_t i = 0; i < 3; ++i) writer.point(mesh.vertices_mm[mesh.face(face)[i]]);
    writer.bytes(0, 2);
  }
  writer.finish();
}

void write_jsonl(const Surface& surface, std::ostream& out) {
  Writer writer(out);
  for (const Polygon& polygon : surface.polygons) {
    writer.text("{\"normal\":");
    write_vertex(normal(polygon.incidence), writer);
    writer.text(",\"rings\":[");
    const char* separator = "";
    for (const Ring& ring : polygon.rings) {
      writer.text(separator);
      write_ring(ring, writer);
      separator = ",";
    }
    writer.text("]}\n");
  }
  writer.finish();
}

}  // namespace discmc::host
