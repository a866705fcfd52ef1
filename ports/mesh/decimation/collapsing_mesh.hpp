// A triangle mesh whose edges collapse to points.
#ifndef DISCMC_MESH_DECIMATION_COLLAPSING_MESH_HPP
#define DISCMC_MESH_DECIMATION_COLLAPSING_MESH_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshes/box_tree.hpp"
#include "meshes/delaunay.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// The changes by the collapse of an edge.
struct Collapse {
  /// A moving triangle, which has one end of the edge.
  struct Moved {
    std::uint32_t triangle;
    Triangle numbers;  ///< after the collapse
    Corners before, after;
  };

  std::uint32_t kept = 0, gone = 0;    ///< the vertices of the edge
  Point at{};                          ///< new position of the kept vertex
  std::vector<std::uint32_t> removed;  ///< triangles with both vertices
  std::vector<Moved> moved;
};

/// A mesh that loses triangles. Vertices and triangles keep their numbers. Memory: 40 bytes per
/// triangle, 33 per vertex.
class CollapsingMesh {
 public:
  CollapsingMesh(std::vector<Point> points, std::vector<Triangle> triangles);

  /// Upper bounds of numbers, including removed vertices and triangles.
  std::uint32_t vertex_slots() const { return static_cast<std::uint32_t>(points_.size()); }
  std::uint32_t triangle_slots() const { return static_cast<std::uint32_t>(triangles_.size()); }
  /// Returns the number of triangles that are left.
  std::size_t triangle_count() const { return triangle_count_; }

  bool has_vertex(std::uint32_t vertex) const { return first_corner_[vertex] != none; }
  bool has_triangle(std::uint32_t triangle) const { return triangles_[triangle][0] != none; }
  const Point& point(std::uint32_t vertex) const { return points_[vertex]; }
  const Triangle& triangle(std::uint32_t triangle) const { return triangles_[triangle]; }
  Corners corners(std::uint32_t triangle) const {
    const Triangle& vertices = triangles_[triangle];
    return {points_[vertices[0]], points_[vertices[1]], points_[vertices[2]]};
  }

  /// Whether an edge of the vertex has only one triangle.
  bool is_border(std::uint32_t vertex) const { return kind_[vertex] == Kind::border; }
  /// Whether the triangles around the vertex are not a single fan, so that the vertex must stay.
  bool is_fixed(std::uint32_t vertex) const { return kind_[vertex] == Kind::fixed; }
  /// Returns a number that is equal for vertices once connected by edges.
  std::uint32_t body(std::uint32_t vertex) const { return body_[vertex]; }

  /// Calls `call` with each triangle of a vertex, and the corner of the vertex there, 0 to 2.
  template <class Call>
  void for_each_triangle(std::uint32_t vertex, Call call) const {
    std::uint32_t corner = first_corner_[vertex];
    if (corner == none) return;
    do {
      call(corner / 3, corner % 3);
      corner = next_corner_[corner];
    } while (corner != first_corner_[vertex]);
  }
  /// Calls `call` once for each edge of a vertex, with the other end.
  template <class Call>
  void for_each_edge(std::uint32_t vertex, Call call) const {
    for_each_triangle(vertex, [&](std::uint32_t triangle, std::uint32_t corner) {
      call(triangles_[triangle][(corner + 1) % 3]);
      const std::uint32_t before = triangles_[triangle][(corner + 2) % 3];
      if (is_border(vertex) && is_border(before) && count_triangles(vertex, before) == 1)
        call(before);
    });
  }
  /// Returns the number of triangles of an edge.
  unsigned count_triangles(std::uint32_t a, std::uint32_t b) const;

  /// Describes a collapse without carrying it out.
  void describe(std::uint32_t kept, std::uint32_t gone, const Point& at, Collapse& collapse) const;
  /// Whether the surface stays closed and manifold where it was. This holds if the common
  /// neighbours of the edge's ends are exactly the corners of its triangles (link condition, T. Dey
  /// et al., 1999).
  bool keeps_topology(const Collapse& collapse);
  void carry_out(const Collapse& collapse);

 private:
  enum class Kind : std::uint8_t { inner, border, fixed };
  static constexpr std::uint32_t none = ~0U;

  // A step from one neighbour of a vertex to the next, across a triangle.
  struct Spoke {
    std::uint32_t from, to;
  };

  void classify_vertices();
  Kind kind_of(std::uint32_t vertex, std::vector<Spoke>& spokes) const;
  void number_bodies();
  void link(std::uint32_t vertex, std::uint32_t corner);
  void unlink(std::uint32_t vertex, std::uint32_t corner);

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;  // removed if the first number is none
  std::size_t triangle_count_;
  // The corners at a vertex form a linked ring. Corner i of triangle t has the number 3 t + i.
  std::vector<std::uint32_t> first_corner_, next_corner_;
  std::vector<Kind> kind_;
  std::vector<std::uint32_t> body_;
  std::vector<std::uint32_t> mark_;  // temporary marks of neighbours
  std::uint32_t last_mark_ = 0;
};

}  // namespace discmc::meshing

#endif
