// Triangulation of a polygon with holes in its plane, in integers.
#ifndef DISCMC_MESH_MESHES_TRIANGULATOR_HPP
#define DISCMC_MESH_MESHES_TRIANGULATOR_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay.hpp"
#include "ears.hpp"

namespace discmc::meshing {

/// Triangulates one polygon after the other, in memory that it keeps.
///
/// Cuts ears off a single ring of few points. All else is triangulated by a sweep over the points,
/// from left to right, after S. Hertel and K. Mehlhorn, Fast Triangulation of Simple Polygons,
/// 1983. Then edges are flipped until the triangles are Delaunay's. All decisions but on flips are
/// exact.
class Triangulator {
 public:
  /// Triangulates the polygon that rings bound. points: ring after ring, the outer ring
  /// counter-clockwise, the holes clockwise; equal ones are one point. ring_ends: of every ring the
  /// place behind its last point. Rings may touch in a point, also in the middle of a side, and may
  /// have collinear points.
  ///
  /// Returns counter-clockwise triples of places in `points`, valid until the next call; of equal
  /// points it may be the place of any. Every point is a corner of some triangle. No triangle has
  /// zero area or a point on one of its sides, and the areas add up to the polygon's exactly.
  /// Time: n log n for n points, beside the flips, and what moving an array of the edges costs that
  /// lie side by side.
  /// Returns none if rings cross or share a stretch, if they do not bound a polygon, or if a point
  /// is beyond max_plane_coordinate.
  const std::vector<Triangle>& triangulate(const std::vector<PlanePoint>& points,
                                           const std::vector<std::uint32_t>& ring_ends);

 private:
  // The rank of a point from left to right; at equal u the lower point is left.
  using Rank = std::uint32_t;
  struct Edge {
    Rank left, right;
    bool is_floor;  // the inside is above it
  };
  // The inside between two edges that lie side by side, to the right of the triangles cut so far.
  // It begins at a chain of points that leaves no triangle to cut.
  struct Node {
    Rank point;
    std::uint32_t below, above;  // the next nodes of the chain
  };
  struct Chain {
    std::uint32_t bottom, top;  // the left ends of the two edges
    std::uint32_t rightmost;
  };
  struct ActiveEdge {
    Edge edge;
    Chain chain;  // of what is above a floor
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
    std::uint32_t place;
  };
  std::vector<Located> located_;
  std::vector<Rank> ranks_;            // of every place
  std::vector<PlanePoint> at_;         // of every rank
  std::vector<std::uint32_t> places_;  // of every rank
  std::vector<Edge> edges_;            // by their left ends
  std::vector<std::uint32_t> edges_begin_;
  std::vector<ActiveEdge> active_;  // those that the sweep meets, from bottom to top
  std::vector<Edge> leaving_;       // those that continue from a point, from bottom to top
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
  Ears ears_;
  std::vector<std::uint32_t> pairs_;  // of sides, as ears have them
  DelaunayFlips flips_;
};

}  // namespace discmc::meshing

#endif
