// Stores triangulations, because most polygons of a surface have few corners, and few shapes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshes/triangulator.hpp"

namespace discmc::web {

/// Like a Triangulator, which triangulates shapes that are not stored yet. Keeps its memory, and
/// the shapes, from one surface to the next.
class TriangleStore {
 public:
  TriangleStore();

  /// Like Triangulator::triangulate(). points: the first is at 0, 0. The triples are valid until
  /// the next call.
  struct Triangles {
    const meshing::Triangle* begin;
    std::size_t count;
  };
  Triangles triangulate(const std::vector<meshing::PlanePoint>& points,
                        const std::vector<std::uint32_t>& ring_ends);

 private:
  static constexpr std::size_t max_points = 16;
  static constexpr std::size_t slot_count = std::size_t{1} << 15;

  // One ring of few points, all near the first one.
  struct Shape {
    std::uint32_t points = 0;
    std::int8_t at[2 * max_points] = {};
  };
  struct Slot {
    Shape shape;
    std::uint32_t triangles = 0;
    meshing::Triangle triangle[max_points - 2];
  };

  static bool shape_of(const std::vector<meshing::PlanePoint>& points, Shape& shape);
  Slot& slot_of(const Shape& shape);

  meshing::Triangulator triangulator_;
  std::vector<Slot> slots_;  // one shape each: the last one with this hash
};

}  // namespace discmc::web
