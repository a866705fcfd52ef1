// The half-step lattice: vertices, links, incidences and the directions of a plane.
//
// Every coordinate is an integer in half-steps: voxel (i, j, k) lies at (2i, 2j, 2k) and a cell
// spans two steps. Vertices of the surface are the points with an odd coordinate sum (edge
// midpoints and cell centroids). Two neighbouring vertices are joined by a link, one of 18 vectors.
// A facet's normal, reduced to signs, is its incidence: one of 26 vectors that point from on to
// off.
//
// Montani, Scateni, Scopigno, "Discretized Marching Cubes", IEEE Visualization 1994, section 2.
// Chains: H. Freeman, "On the encoding of arbitrary geometric configurations", 1961.
#ifndef DISCMC_LATTICE_HPP
#define DISCMC_LATTICE_HPP

#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc {

/// A point or a vector of the lattice. Units: half-steps.
struct Vertex {
  int32_t x, y, z;
};

constexpr bool operator==(const Vertex& a, const Vertex& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
constexpr bool operator!=(const Vertex& a, const Vertex& b) {
  return !(a == b);
}
/// Whether a precedes b in the order of z, then y, then x.
constexpr bool precedes(const Vertex& a, const Vertex& b) {
  return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
}
constexpr Vertex operator+(const Vertex& a, const Vertex& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vertex operator-(const Vertex& a, const Vertex& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vertex operator-(const Vertex& a) {
  return {-a.x, -a.y, -a.z};
}
/// Moves v along a vector this many times. Coordinates wrap.
constexpr void translate(Vertex& v, const Vertex& step, uint32_t times) {
  const auto add = [times](int32_t& coordinate, int32_t by) {
    coordinate =
        static_cast<int32_t>(static_cast<uint32_t>(coordinate) + static_cast<uint32_t>(by) * times);
  };
  add(v.x, step.x);
  add(v.y, step.y);
  add(v.z, step.z);
}
/// Wraps, because coordinates may be near their limits.
constexpr int32_t dot_product(const Vertex& a, const Vertex& b) {
  const auto product = [](int32_t one, int32_t other) {
    return static_cast<uint32_t>(one) * static_cast<uint32_t>(other);
  };
  return static_cast<int32_t>(product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z));
}
constexpr Vertex cross(const Vertex& a, const Vertex& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr int32_t component(const Vertex& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The axis of the edge whose midpoint a vertex is; 3 for a centroid.
constexpr uint32_t axis_of(const Vertex& v) {
  const auto odd = [](int32_t coordinate) { return static_cast<uint32_t>(coordinate) & 1; };
  return (odd(v.x) | odd(v.y) << 1 | odd(v.z) << 2) >> 1;
}

/// A signed normal as a number: 13 + x + 3 y + 9 z for components in {-1, 0, 1}. Limit: 0 to 26;
/// 13, the zero vector, is not an incidence.
using Incidence = uint8_t;

constexpr Incidence no_incidence = 13;
constexpr int incidence_codes = 27;

/// The normal of an incidence.
constexpr Vertex incidence_normal(Incidence incidence) {
  // Without divisions: the smallest processors have no instruction for them.
  const int by_3 = incidence * 171 >> 9, by_9 = incidence * 57 >> 9;
  return {incidence - 3 * by_3 - 1, by_3 - 3 * by_9 - 1, by_9 - 1};
}
/// The incidence of a normal. Limit: its components are -1, 0 or 1.
constexpr Incidence incidence_of(const Vertex& normal) {
  return static_cast<Incidence>(13 + normal.x + 3 * normal.y + 9 * normal.z);
}
/// The incidence of the opposite normal.
constexpr Incidence opposite(Incidence incidence) {
  return static_cast<Incidence>(26 - incidence);
}

/// One of the 18 link vectors as a number; the opposite link is 17 - link.
using Link = uint8_t;

constexpr int link_codes = 18;

constexpr Link opposite_link(Link link) {
  return static_cast<Link>(17 - link);
}

/// A link's direction within the plane of an incidence: 0 to direction_count - 1,
/// counter-clockwise seen from the tip of the normal.
using Direction = uint8_t;

constexpr int max_directions = 8;
constexpr Direction no_direction = 0xFF;

/// The 18 links, and which of them lie in the planes of each incidence. Read the table through the
/// functions below.
struct LinkTable {
  int8_t vector[link_codes][3];
  uint8_t direction_count[incidence_codes];        ///< 8 in axis planes, 4 in diagonal
                                                   ///< planes, 6 in corner planes
  Link link[incidence_codes][max_directions / 2];  ///< of the first half of the directions
};

namespace detail::derive {

constexpr Vertex link_vector(const LinkTable& table, Link link) {
  return {table.vector[link][0], table.vector[link][1], table.vector[link][2]};
}

constexpr Link link_of(const LinkTable& table, const Vertex& vector) {
  for (Link link = 0; link < link_codes; ++link)
    if (link_vector(table, link) == vector) return link;
  return link_codes;
}

// The next link of the plane counter-clockwise from `from`, with no other link between them.
constexpr Link next_link(const LinkTable& table, const Vertex& normal, Link from) {
  Link best = link_codes;
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex candidate = link_vector(table, link);
    if (dot_product(candidate, normal) != 0) continue;
    if (dot_product(cross(link_vector(table, from), candidate), normal) <= 0) continue;
    if (best == link_codes || dot_product(cross(candidate, link_vector(table, best)), normal) > 0)
      best = link;
  }
  return best;
}

constexpr void add_plane(LinkTable& table, Incidence incidence) {
  const Vertex n = incidence_normal(incidence);
  Link first = 0;
  while (dot_product(link_vector(table, first), n) != 0) ++first;
  uint8_t half = 0;
  for (Link link = first; link != opposite_link(first); link = next_link(table, n, link))
    table.link[incidence][half++] = link;
  table.direction_count[incidence] = static_cast<uint8_t>(2 * half);
}

constexpr LinkTable link_table() {
  LinkTable table{};
  int count = 0;
  for (int8_t z = -2; z <= 2; ++z)
    for (int8_t y = -2; y <= 2; ++y)
      for (int8_t x = -2; x <= 2; ++x) {
        const int length_squared = x * x + y * y + z * z;
        const bool is_diagonal = length_squared == 2;
        const bool is_along_axis = length_squared == 4;
        if (!is_diagonal && !is_along_axis) continue;
        table.vector[count][0] = x;
        table.vector[count][1] = y;
        table.vector[count][2] = z;
        ++count;
      }
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    if (incidence != no_incidence) add_plane(table, incidence);
  return table;
}

}  // namespace detail::derive

namespace detail {

inline constexpr LinkTable link_table = derive::link_table();

}  // namespace detail

/// The number of directions in the planes of an incidence: 8 in axis planes, 4 in diagonal
/// planes, 6 in corner planes.
constexpr uint8_t direction_count(Incidence incidence) {
  return detail::link_table.direction_count[incidence];
}

/// The vector of a link. Units: half-steps.
constexpr Vertex link_vector(Link link) {
  return detail::derive::link_vector(detail::link_table, link);
}

/// The link of a direction in the planes of an incidence.
constexpr Link link_of(Incidence incidence, Direction direction) {
  const int half = direction_count(incidence) / 2;
  const Link* first_half = detail::link_table.link[incidence];
  return direction < half ? first_half[direction] : opposite_link(first_half[direction - half]);
}

/// The direction of a link in the planes of an incidence, or no_direction if the link lies in none.
constexpr Direction direction_of(Incidence incidence, Link link) {
  const int half = direction_count(incidence) / 2;
  for (int i = 0; i < half; ++i) {
    if (detail::link_table.link[incidence][i] == link) return static_cast<Direction>(i);
    if (detail::link_table.link[incidence][i] == opposite_link(link))
      return static_cast<Direction>(i + half);
  }
  return no_direction;
}

/// As above, for a link vector. Cost: a search, so not per run.
constexpr Direction direction_of(Incidence incidence, const Vertex& vector) {
  return direction_of(incidence, detail::derive::link_of(detail::link_table, vector));
}

/// The vector of a direction in the planes of an incidence. Units: half-steps.
constexpr Vertex direction_vector(Incidence incidence, Direction direction) {
  return link_vector(link_of(incidence, direction));
}

/// Moves v this many times along a link or a direction; 0 - n moves back n times. Coordinates wrap.
constexpr void translate(Vertex& v, Link link, uint32_t times) {
  translate(v, link_vector(link), times);
}
constexpr void translate(Vertex& v, Incidence incidence, Direction direction, uint32_t times) {
  translate(v, link_of(incidence, direction), times);
}

/// The opposite direction.
constexpr Direction opposite_direction(Incidence incidence, Direction direction) {
  const int half = direction_count(incidence) / 2;
  return static_cast<Direction>(direction < half ? direction + half : direction - half);
}

/// The turn from one direction to the next as a number of directions, counter-clockwise if
/// positive. It is between -n/2 (also for a half turn) and n/2 - 1. Here n is the incidence's
/// direction_count.
constexpr int turn(Incidence incidence, Direction from, Direction to) {
  const int count = direction_count(incidence);
  const int difference = to - from;
  if (difference < -count / 2) return difference + count;
  if (difference >= count / 2) return difference - count;
  return difference;
}

static_assert(direction_count(incidence_of({0, 0, 1})) == 8, "axis planes have 8 directions");
static_assert(direction_count(incidence_of({1, 1, 0})) == 4, "diagonal planes have 4");
static_assert(direction_count(incidence_of({1, 1, 1})) == 6, "corner planes have 6");
static_assert(link_vector(opposite_link(3)) == -link_vector(3),
              "links are numbered by point symmetry");

}  // namespace discmc

#endif
