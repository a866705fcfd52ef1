// From chains to polygons: vertices, simple rings, corners.
//
// A ring of a region may touch itself in a vertex. split_ring() splits a ring at every repeated
// vertex into simple rings, as polygon libraries expect. The set of simple rings is unique. Rings
// of two links, which are slits without area, are dropped. All functions work in the caller's
// memory.
#ifndef DISCMC_POLYGON_HPP
#define DISCMC_POLYGON_HPP

#include <discmc/chain.hpp>

namespace discmc {

/// The number of links of a chain, which is the number of vertices of a closed one. Limit: straight
/// runs only.
constexpr uint64_t link_count(const Run* runs, uint32_t count) {
  uint64_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) sum += runs[i].length();
  return sum;
}

/// Writes the vertices of a closed chain, one per link, beginning with the start. vertices:
/// link_count() of them; Owner: the caller. Limit: straight runs only.
void ring_vertices(Incidence incidence, const Vertex& start, const Run* runs, uint32_t count,
                   Vertex* vertices);

/// Twice a ring's area times the length of its incidence's normal, as twice_area() of a chain:
/// positive for an outer ring, negative for a hole. Units: square half-steps.
int64_t twice_area(Incidence incidence, const Vertex* vertices, uint32_t count);

/// A sink of simple rings. Owner: the context belongs to the caller.
struct RingSink {
  void* context = nullptr;
  /// Receives a ring of three or more vertices, one per link; valid during the call.
  void (*take)(void* context, const Vertex* vertices, uint32_t count) = nullptr;
};

/// Splits a closed ring of vertices into simple rings, and sends them to the sink. vertices:
/// overwritten. scratch: 2 * count words. Owner: the caller. Cost: count * log(count) comparisons.
void split_ring(Vertex* vertices, uint32_t count, uint32_t* scratch, const RingSink& sink);

/// Whether vertex i of a ring is a corner: the links before and after it differ.
bool is_corner(const Vertex* vertices, uint32_t count, uint32_t i);

/// Keeps, in order and in place, the corners of a ring and every vertex for which keep(vertex) is
/// true; returns their number. For a mesh without T-junctions keep the vertices at which three or
/// more boundary links of the surface end, and triangulate without dropping collinear points.
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
