// Delaunay's triangles from any others: the roundest that the points allow.
#ifndef DISCMC_MESH_MESHES_DELAUNAY_HPP
#define DISCMC_MESH_MESHES_DELAUNAY_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "surface/array.hpp"

namespace discmc::meshing {

/// A point of a polygon in its plane. Limit: magnitude up to max_plane_coordinate.
struct PlanePoint {
  std::int64_t u, v;
};

/// Keeps the doubled area of three points within 64 bits.
constexpr std::int64_t max_plane_coordinate = std::int64_t{1} << 29;

/// Twice the area of a triangle: positive where its corners are in counter-clockwise order.
inline std::int64_t doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/// Whether d lies inside the circle around a, b and c, which are in counter-clockwise order. False
/// when in doubt, so that flips come to an end. Limit: c and d lie on two sides of the line a b.
bool is_in_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c,
                  const PlanePoint& d);

/// The numbers of three points.
using Triangle = std::array<std::uint32_t, 3>;

/// Flips the edges that two triangles share until no point lies inside the circle around a triangle
/// that it sees. Keeps its memory from one call to the next.
class DelaunayFlips {
 public:
  /// Side i of triangle t goes from its corner i to the next one and has the number 3 t + i.
  using Side = std::uint32_t;
  static constexpr Side no_side = 0xFFFFFFFFu;

  /// triangles: counter-clockwise, none without area; two that share an edge have the same two
  /// points there.
  void improve(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles);
  /// The same if it is known of every side which is the other one between the same points. pairs:
  /// unspecified afterwards.
  void improve(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
               std::vector<Side>& pairs);

  /// Adds the last of the points to the triangles, as the last call left them. triangle: the place
  /// of one that the point lies in, or on an edge that it shares.
  void insert(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
              std::uint32_t triangle);

  /// The places of the triangles that the last insert() made or changed, some of them repeatedly.
  const std::vector<std::uint32_t>& changed() const { return changed_; }

  /// Whether another triangle has the edge from this corner of a triangle to the next one.
  bool is_shared(std::uint32_t triangle, std::uint32_t corner) const {
    return twins_[3 * triangle + corner] != no_side;
  }

 private:
  void flip_all(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles);
  void pair_sides(const std::vector<Triangle>& triangles);
  void flip_waiting(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles);
  void link(Side a, Side b);
  void flip(std::vector<Triangle>& triangles, Side side);

  struct Ends {
    std::uint32_t low, high;
    Side side;
  };
  std::vector<Ends> ends_;
  std::vector<Side> twins_;  // of every side the other one between the same points
  Array<Side> waiting_;      // to be looked at
  std::vector<std::uint32_t> changed_;
};

}  // namespace discmc::meshing

#endif
