// Shared by the writers of mesh files: numbers as text and as bytes, and the description in each
// file. Internal to the writers.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "array.hpp"
#include "file_mesh.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "mesh_files.hpp"
#include "mesh_parts.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// Returns the description of a mesh, for a comment or a text field of the file. The space has the
/// form that 3D Slicer reads and writes.
std::string header_text(const FileMesh& mesh);

/// Throws std::invalid_argument if a face is not a triangle. format: its name.
void require_triangles(const FileMesh& mesh, const std::string& format);

/// Returns the meshes that have faces.
Meshes with_faces(Meshes meshes);

/// The shortest decimal that reads back as the same value.
template <typename Number>
std::string decimal(Number value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// Writes a real number as little-endian bytes, and returns the end of these bytes. Bits: an
/// integer of the real's width.
template <typename Bits, typename Real>
char* put_real(Real value, char* place) {
  static_assert(std::numeric_limits<Real>::is_iec559 && sizeof(Bits) == sizeof(Real));
  Bits bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (std::size_t i = 0; i < sizeof bits; ++i)
    place[i] = static_cast<char>(bits >> (8 * i) & 0xFF);
  return place + sizeof bits;
}

/// Likewise writes three 32-bit floats.
inline char* put_floats(const Point& point, char* place) {
  for (const double coordinate : point)
    place = put_real<std::uint32_t>(static_cast<float>(coordinate), place);
  return place;
}

/// Collects small writes. Throws std::runtime_error if the stream fails.
class Writer {
 public:
  explicit Writer(std::ostream& out) : Writer() { out_ = &out; }

  void text(std::string_view text);

  template <typename Number>
  void decimal(Number value) {
    text(command::decimal(value));
  }

  /// Returns the place of the next bytes, for the caller to fill. Limit: 64 KiB.
  char* room_for(std::size_t count) {
    if (used_ + count > buffer_.size()) make_room(count);
    char* const place = buffer_.begin() + used_;
    used_ += count;
    return place;
  }

  /// Writes the lowest bytes of a value, little endian.
  void bytes(std::uint64_t value, std::size_t count) {
    char* const place = room_for(count);
    for (std::size_t i = 0; i < count; ++i) place[i] = static_cast<char>(value >> (8 * i) & 0xFF);
  }

  /// Writes three 32-bit floats, little endian.
  void floats(const Point& point) { put_floats(point, room_for(3 * sizeof(float))); }
  /// Writes three 64-bit floats, little endian.
  void doubles(const Point& point) {
    char* place = room_for(3 * sizeof(double));
    for (const double coordinate : point) place = put_real<std::uint64_t>(coordinate, place);
  }

  /// Calls write(writer, item) for items 0 to count - 1, in parallel and with several writers. The
  /// items are written in order.
  template <typename Write>
  void items(unsigned jobs, std::size_t count, const Write& write) {
    struct Nothing {};
    parts<Nothing>(
        jobs, (count + items_per_part - 1) / items_per_part,
        [&write, count](Writer& part, std::size_t number, Nothing&) {
          const std::size_t first = number * items_per_part;
          const std::size_t end = std::min(first + items_per_part, count);
          for (std::size_t item = first; item < end; ++item) write(part, item);
        },
        [](Nothing&) {});
  }

  /// Likewise calls write(writer, number, room) for parts 0 to count - 1, and consume(room) after a
  /// part is written. Later parts reuse a room.
  template <typename Room, typename Write, typename Consume>
  void parts(unsigned jobs, std::size_t count, const Write& write, const Consume& consume) {
    struct Part {
      Writer writer{};  // calls the private constructor
      Room room{};
    };
    run_in_order<Part>(
        jobs, count, [](std::size_t, Part& part) { part.writer.used_ = 0; },
        [&write](std::size_t number, Part& part) { write(part.writer, number, part.room); },
        [this, &consume](std::size_t, Part& part) {
          write_through({part.writer.buffer_.data(), part.writer.used_});
          consume(part.room);
        });
  }

  /// Writes what is still collected. Call it last.
  void finish();
  /// Calls finish(), then overwrites the first bytes of the stream. Limit: a stream that can seek.
  void finish_with_start(std::string_view start);

 private:
  static constexpr std::size_t full = std::size_t{1} << 16;
  static constexpr std::size_t items_per_part = std::size_t{1} << 14;

  Writer() { buffer_.resize(full); }  // for a part, without a stream

  void make_room(std::size_t count);
  void write_through(std::string_view bytes);
  void flush();

  std::ostream* out_ = nullptr;
  meshing::Array<char> buffer_;
  std::size_t used_ = 0;
};

/// Writes the faces of all blocks in order. make: make_faces or make_triangles. Calls write(mesh,
/// face, writer) for each face.
/// write(mesh, face, writer) for each.
template <class Write>
MeshTotals write_faces(const MeshParts& parts,
                       void (MeshParts::*make)(std::size_t, MeshParts::Block&) const,
                       Writer& writer, const Write& write) {
  MeshTotals totals;
  writer.parts<MeshParts::Block>(
      parts.jobs(), parts.block_count(),
      [&](Writer& part, std::size_t number, MeshParts::Block& block) {
        (parts.*make)(number, block);
        for (std::size_t face = 0; face < block.faces.face_count(); ++face)
          write(block.faces, face, part);
      },
      [&](const MeshParts::Block& block) { add(block, totals); });
  return totals;
}

}  // namespace discmc::command
