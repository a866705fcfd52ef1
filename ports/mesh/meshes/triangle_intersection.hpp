// Checks whether two triangles of a mesh intersect.
#ifndef DISCMC_MESH_MESHES_TRIANGLE_INTERSECTION_HPP
#define DISCMC_MESH_MESHES_TRIANGLE_INTERSECTION_HPP

#include <cstddef>
#include <cstdint>

#include "box_tree.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// A triangle of a mesh: the numbers and positions of its vertices.
struct PlacedTriangle {
  const std::uint32_t* numbers;
  Corners corners;
};

/// The plane of a triangle.
class TrianglePlane {
 public:
  explicit TrianglePlane(const Corners& triangle)
      : origin_(triangle[0]),
        normal_(doubled_area(triangle)),
        squared_length_(dot(normal_, normal_)) {}

  /// Returns the side on which a point lies: 1, -1, or 0 for in the plane or uncertain.
  int side_of(const Point& point) const {
    const Point away = difference(point, origin_);
    const double height = dot(normal_, away);
    constexpr double unsure = 1e-20;
    const int is_sure = height * height > unsure * squared_length_ * dot(away, away);
    return is_sure * ((height > 0) - (height < 0));
  }

 private:
  Point origin_, normal_;
  double squared_length_;
};

/// A triangle that is compared with several others.
struct ComparedTriangle : PlacedTriangle {
  explicit ComparedTriangle(const PlacedTriangle& triangle)
      : PlacedTriangle(triangle), plane(triangle.corners) {}
  TrianglePlane plane;
};

/// Returns the number of vertices that two triangles share.
inline unsigned count_shared(const std::uint32_t* a, const std::uint32_t* b) {
  unsigned count = 0;  // without branches, like Box::overlaps()
  for (std::size_t i = 0; i < 3; ++i) count += (a[i] == b[0]) | (a[i] == b[1]) | (a[i] == b[2]);
  return count;
}

/// Whether two triangles meet outside their shared vertex. False if they lie in one plane. Limit:
/// no shared edge.
bool intersect(const ComparedTriangle& a, const PlacedTriangle& b);

}  // namespace discmc::meshing

#endif
