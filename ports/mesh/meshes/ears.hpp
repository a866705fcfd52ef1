// Triangulation of a small simple ring by cutting ears.
#ifndef DISCMC_MESH_MESHES_EARS_HPP
#define DISCMC_MESH_MESHES_EARS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay.hpp"

namespace discmc::meshing {

/// Cuts ears off a ring: triangles of three neighbouring points with no other point inside. It
/// finds at once which triangles share a side. Time grows as the square of the points, so few
/// points take less time than by a sweep, which sorts them. G. H. Meisters, Polygons have ears,
/// 1975.
class Ears {
 public:
  static constexpr std::size_t max_points = 64;

  /// Whether the ring is one for ears: 3 to max_points points, counter-clockwise, whose sides meet
  /// in their common points only. Then triangles and pairs are set. Triangles are
  /// counter-clockwise, and none has zero area. Each side, numbered as by DelaunayFlips, has the
  /// other one between the same points.
  bool cut(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
           std::vector<std::uint32_t>& pairs);

 private:
  void link_all(const std::vector<PlanePoint>& points);
  bool is_flat_or_reflex(const std::vector<PlanePoint>& points, std::uint32_t at) const;
  bool is_ear(const std::vector<PlanePoint>& points, std::uint32_t at) const;
  void cut_off(std::uint32_t at, std::vector<Triangle>& triangles,
               std::vector<std::uint32_t>& pairs);
  void update(const std::vector<PlanePoint>& points, std::uint32_t at);

  std::uint32_t left_ = 0;       // points that are not cut off
  std::uint32_t cut_count_ = 0;  // triangles
  std::uint32_t blockers_ = 0;   // how many of them block
  std::uint32_t next_[max_points], previous_[max_points];
  bool blocks_[max_points];          // flat or reflex: only such points can lie in an ear
  std::uint32_t inner_[max_points];  // the side cut between a point and the next, or none
};

}  // namespace discmc::meshing

#endif
