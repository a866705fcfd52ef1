// From chains to polygons: vertices, simple rings, corners.
//
// A ring of a region may touch itself in a vertex. Most polygon libraries need simple rings, so
// split_ring() splits a ring at every vertex that it visits more than once. All functions work in
// memory that you supply.
//
//   ring_vertices()  ->  split_ring()  ->  keep_corners()  ->  your polygons or triangles
#ifndef DISCMC_POLYGON_HPP
#define DISCMC_POLYGON_HPP

#include <discmc/chain.hpp>

namespace discmc {

/// The number of links of a chain; a closed chain has as many vertices. Limit: valid runs, see
/// is_run_of().
constexpr uint64_t link_count(const Run* runs, uint32_t count) {
  uint64_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) sum += runs[i].length();
  return sum;
}

/// Writes the vertices of a closed chain, one per link, beginning with `start`. vertices: room for
/// link_count(runs, count) vertices; Owner: the caller. Limit: valid runs, whose chain is closed.
void ring_vertices(Incidence incidence, const Vertex& start, const Run* runs, uint32_t count,
                   Vertex* vertices);

/// Twice the area of a ring, times the length of its incidence's normal: an exact integer, equal to
/// twice_area() of the ring's chain. Positive for an outer ring, negative for a hole. Units: square
/// half-steps.
int64_t twice_area(Incidence incidence, const Vertex* vertices, uint32_t count);

/// A sink of simple rings. Owner: the context belongs to the caller.
struct RingSink {
  void* context = nullptr;
  /// Called by split_ring() for each simple ring: three or more vertices, one per link; valid
  /// during the call.
  void (*accept)(void* context, const Vertex* vertices, uint32_t count) = nullptr;
};

/// Splits a ring of vertices, as ring_vertices() writes it, into simple rings, and sends each to
/// the sink. Each simple ring keeps the direction of the ring, so twice_area() distinguishes outer
/// rings from holes. Rings of two links enclose no area and are dropped. vertices: overwritten.
/// scratch: 2 * count elements of uint32_t. Owner of both: the caller. Cost: count * log(count)
/// comparisons.
void split_ring(Vertex* vertices, uint32_t count, uint32_t* scratch, const RingSink& sink);

/// Whether vertex i of a ring is a corner: the links before and after it differ. Limit: i < count.
bool is_corner(const Vertex* vertices, uint32_t count, uint32_t i);

/// Keeps the corners of a ring, and every vertex for which keep(vertex) is true. Moves them to the
/// front of `vertices`, in their order, and returns their number. A mesh has no T-junctions on two
/// conditions. keep() is true wherever three or more boundary links end, and the triangulation
/// drops no collinear points.
template <class Keep>
uint32_t keep_corners(Vertex* vertices, uint32_t count, Keep keep);

/// Keeps only the corners.
inline uint32_t keep_corners(Vertex* vertices, uint32_t count) {
  return keep_corners(vertices, count, [](const Vertex&) { return false; });
}

// ---- implementation ----

template <class Keep>
uint32_t keep_corners(Vertex* vertices, uint32_t count, Keep keep) {
  if (count == 0) return 0;
  const Vertex first = vertices[0];
  Vertex before = vertices[count - 1];
  uint32_t kept = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const Vertex vertex = vertices[i];
    const Vertex after = i + 1 < count ? vertices[i + 1] : first;
    if (vertex - before != after - vertex || keep(vertex)) vertices[kept++] = vertex;
    before = vertex;
  }
  return kept;
}

}  // namespace discmc

#endif
