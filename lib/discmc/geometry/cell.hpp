// One cell: its eight corners, the points of the half-step lattice in it, and the loops in which
// the surface crosses its faces.
// Corner c lies at (c & 1, c >> 1 & 1, c >> 2); bit c of a configuration is 1 if the corner is on.
//
//          6-------7
//         /|      /|        z
//        4-------5 |        | y
//        | 2-----|-3        |/
//        |/      |/         o-- x
//        0-------1
// One rule defines the surface (Montani et al. 1994, section 2, with a rule for ambiguous faces):
// on each cell face, join the edge crossings so that on corners are separated.
#ifndef DISCMC_CELL_HPP
#define DISCMC_CELL_HPP

#include <discmc/lattice.hpp>

namespace discmc {

/// The eight corner bits of a cell: 0 all off, 255 all on.
using Configuration = uint8_t;

constexpr int configurations = 256;

/// A lattice point of a cell as a number, x + 4 y + 16 z with coordinates 0 to 2.
/// Edge midpoints have one odd coordinate; 21 is the centroid.
using CellPoint = uint8_t;

constexpr int point_codes = 43;
constexpr CellPoint centroid = 21;
constexpr CellPoint no_point = 0xFF;

constexpr Vertex position(CellPoint point) {
  return {point & 3, point >> 2 & 3, point >> 4};
}
constexpr CellPoint point_at(const Vertex& position) {
  return static_cast<CellPoint>(position.x + 4 * position.y + 16 * position.z);
}

/// The faces of a cell. The first three look back at cells that a sweep in x, y, z order has
/// visited.
enum Face : uint8_t { face_left, face_front, face_below, face_right, face_back, face_above };

constexpr int faces = 6;

/// The face on which a link between two edge midpoints lies, or `faces` for a link inside the cell.
constexpr int face_of(CellPoint from, CellPoint to) {
  const Vertex a = position(from);
  const Vertex b = position(to);
  if (a.x == b.x && a.x != 1) return a.x == 0 ? face_left : face_right;
  if (a.y == b.y && a.y != 1) return a.y == 0 ? face_front : face_back;
  if (a.z == b.z && a.z != 1) return a.z == 0 ? face_below : face_above;
  return faces;
}

/// A closed ring of edge midpoints in which the surface meets the faces of a cell,
/// counter-clockwise seen from the off side.
struct Loop {
  static constexpr int max_points = 7;
  uint8_t count;
  CellPoint point[max_points];
};

/// All loops of a cell.
struct Loops {
  static constexpr int max_loops = 4;
  uint8_t count;
  Loop loop[max_loops];
};

namespace detail::derive {

// The corners of a face, counter-clockwise seen from inside the cell.
struct FaceCorners {
  uint8_t corner[4];
};

constexpr FaceCorners face_corners(int face) {
  const int axis = face % 3;
  const int u = 1 << (axis + 1) % 3;
  const int v = 1 << (axis + 2) % 3;
  const bool is_far = face >= 3;
  const int base = is_far ? 1 << axis : 0;
  const int second = is_far ? v : u;
  const int fourth = is_far ? u : v;
  return {{static_cast<uint8_t>(base), static_cast<uint8_t>(base + second),
           static_cast<uint8_t>(base + u + v), static_cast<uint8_t>(base + fourth)}};
}

constexpr Vertex corner_position(int corner) {
  return {2 * (corner & 1), 2 * (corner >> 1 & 1), 2 * (corner >> 2)};
}

constexpr CellPoint midpoint(int corner_a, int corner_b) {
  const Vertex sum = corner_position(corner_a) + corner_position(corner_b);
  return point_at({sum.x / 2, sum.y / 2, sum.z / 2});
}

struct Successors {
  CellPoint next[point_codes];
};

// One link cuts off every run of on corners around a face, and keeps these corners on its left.
constexpr void add_face_links(Configuration configuration, int face, Successors& successors) {
  const FaceCorners ring = face_corners(face);
  bool is_on[4] = {};
  for (int i = 0; i < 4; ++i) is_on[i] = configuration >> ring.corner[i] & 1;
  for (int last = 0; last < 4; ++last) {
    const int after = (last + 1) % 4;
    if (!is_on[last] || is_on[after]) continue;
    int first = last;
    while (is_on[(first + 3) % 4]) first = (first + 3) % 4;
    const int before = (first + 3) % 4;
    successors.next[midpoint(ring.corner[last], ring.corner[after])] =
        midpoint(ring.corner[before], ring.corner[first]);
  }
}

constexpr Loops loops(Configuration configuration) {
  Successors successors{};
  for (CellPoint& next : successors.next) next = no_point;
  for (int face = 0; face < faces; ++face) add_face_links(configuration, face, successors);
  Loops result{};
  for (CellPoint start = 0; start < point_codes; ++start) {
    if (successors.next[start] == no_point) continue;
    Loop& loop = result.loop[result.count++];
    for (CellPoint point = start; point != no_point;) {
      loop.point[loop.count++] = point;
      const CellPoint next = successors.next[point];
      successors.next[point] = no_point;
      point = next == start ? no_point : next;
    }
  }
  return result;
}

}  // namespace detail::derive

}  // namespace discmc

#endif
