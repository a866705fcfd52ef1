// Triangulates a polygon with holes in its plane, with integers.
#ifndef DISCMC_MESH_MESHES_TRIANGULATOR_HPP
#define DISCMC_MESH_MESHES_TRIANGULATOR_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay.hpp"
#include "ears.hpp"

namespace discmc::meshing {

/// Triangulates one polygon after another, and reuses its memory.
///
/// Cuts ears off a single ring of few points. Triangulates all else by a sweep over the points from
/// left to right (S. Hertel and K. Mehlhorn, Fast Triangulation of Simple Polygons, 1983). Then
/// flips edges until the triangles are Delaunay's. All decisions except flips are exact.
class Triangulator {
 public:
  /// Triangulates the polygon bounded by rings. points: ring after ring, the outer ring
  /// counter-clockwise, the holes clockwise; equal points are one point. ring_ends: for each ring,
  /// the index behind its last point. Rings may touch in a point, also within a side, and may have
  /// collinear points.
  ///
  /// Returns counter-clockwise triples of indexes in `points`, valid until the next call. Any index
  /// of equal points may be returned. Every point is a corner of some triangle. No triangle has
  /// zero area or a point on one of its sides, and the areas add up to the polygon's exactly. Time:
  /// n log n for n points, plus flips, and moves of an array with the edges side by side. Returns
  /// none if rings cross or share a stretch, do not bound a polygon, or exceed
  /// max_plane_coordinate.
  const std::vector<Triangle>& triangulate(const std::vector<PlanePoint>& points,
                                           const std::vector<std::uint32_t>& ring_ends);

 private:
  // The rank of a point from left to right; the lower of two points at equal u comes first.
  using Rank = std::uint32_t;
  struct Edge {
    Rank left, right;
    bool is_floor;  // whether the inside is above it
  };
  // The inside between two adjacent edges, to the right of the triangles cut so far. It begins at a
  // chain of points that leaves no triangle to cut.
  struct Node {
    Rank point;
    std::uint32_t below, above;  // neighbours in the chain
  };
  struct Chain {
    std::uint32_t bottom, top;  // left ends of the two edges
    std::uint32_t rightmost;
  };
  struct ActiveEdge {
    Edge edge;
    Chain chain;  // of the inside above a floor
  };

  bool cut_small(const std::vector<PlanePoint>& points);
  void sweep(const std::vector<PlanePoint>& points, const std::vector<std::uint32_t>& ring_ends);
  void sort_points(const std::vector<PlanePoint>& points);
  // These return whether the rings may still bound a polygon.
  bool add_edges(const std::vector<std::uint32_t>& ring_ends);
  bool pass_all();
  bool pass(Rank point);
  bool collect_leaving(Rank point, std::size_t begin, std::size_t end);
  bool are_in_order(std::size_t lower) const;

  std::uint32_t new_node(Rank point);
  bool cut(Rank a, Rank b, Rank c);
  void add_on_top(Chain& chain, Rank point);
  void add_at_bottom(Chain& chain, Rank point);
  void close(Chain chain, Rank point);
  Chain split_off_upper(Chain& chain);
  Chain joined(const Chain& lower, const Chain& upper);

  struct Located {
    PlanePoint point;
    std::uint32_t index;
  };
  std::vector<Located> located_;
  std::vector<Rank> ranks_;             // by index
  std::vector<PlanePoint> at_;          // by rank
  std::vector<std::uint32_t> indexes_;  // by rank
  std::vector<Edge> edges_;             // sorted by left ends
  std::vector<std::uint32_t> edges_begin_;
  std::vector<ActiveEdge> active_;  // edges that the sweep crosses, from bottom to top
  std::vector<Edge> leaving_;       // edges that begin at the point, from bottom to top
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
  Ears ears_;
  std::vector<std::uint32_t> pairs_;  // of sides, from the ears
  DelaunayFlips flips_;
};

}  // namespace discmc::meshing

#endif
