// Turns any triangulation into Delaunay's, which has the roundest triangles.
#ifndef DISCMC_MESH_MESHES_DELAUNAY_HPP
#define DISCMC_MESH_MESHES_DELAUNAY_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "array.hpp"

namespace discmc::meshing {

/// A point of a polygon in its plane. Limit: magnitude up to max_plane_coordinate.
struct PlanePoint {
  std::int64_t u, v;
};

/// This limit keeps the doubled area of three points within 64 bits.
constexpr std::int64_t max_plane_coordinate = std::int64_t{1} << 29;

/// Returns twice the area of a triangle, positive if its corners are counter-clockwise.
inline std::int64_t doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/// Whether d lies inside the circle around a, b and c, which are counter-clockwise. Returns false
/// when in doubt, so that flips end. Limit: c and d lie on two sides of the line a b.
bool is_in_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c,
                  const PlanePoint& d);

/// The numbers of three points.
using Triangle = std::array<std::uint32_t, 3>;

/// Flips shared edges until no triangle's circumscribed circle contains the opposite point of a
/// neighbour. Keeps its memory between calls.
class DelaunayFlips {
 public:
  /// Side i of triangle t goes from corner i to the next one, and has the number 3 t + i.
  using Side = std::uint32_t;
  static constexpr Side no_side = 0xFFFFFFFFu;

  /// triangles: counter-clockwise, none with zero area. Neighbours share the numbers of both points
  /// of their edge.
  void improve(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles);
  /// Likewise, with the given twin of each side: the other side between its two points. pairs:
  /// unspecified afterwards.
  void improve(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
               std::vector<Side>& pairs);

  /// Inserts the last point into the triangles of the previous call. triangle: a triangle that
  /// contains the point, inside or on a shared edge.
  void insert(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
              std::uint32_t triangle);

  /// Returns the triangles that the last insert() made or changed, possibly repeated.
  const std::vector<std::uint32_t>& changed() const { return changed_; }

  /// Whether another triangle shares the edge from this corner to the next one.
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
  std::vector<Side> twins_;  // per side: the other side between its points
  Array<Side> waiting_;      // sides to check
  std::vector<std::uint32_t> changed_;
};

}  // namespace discmc::meshing

#endif
