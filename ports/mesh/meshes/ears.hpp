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
  bool is_simple(const std::vector<PlanePoint>& points);
  void set_boxes(const std::vector<PlanePoint>& points);
  bool are_near(std::size_t i, std::size_t j) const {
    return (low_u_[i] <= high_u_[j]) & (low_u_[j] <= high_u_[i]) & (low_v_[i] <= high_v_[j]) &
           (low_v_[j] <= high_v_[i]);
  }
  bool is_flat_or_reflex(const std::vector<PlanePoint>& points, std::uint32_t at) const;
  bool is_ear(const std::vector<PlanePoint>& points, std::uint32_t at) const;
  void cut_off(std::uint32_t at, std::vector<Triangle>& triangles,
               std::vector<std::uint32_t>& pairs);
  void update(const std::vector<PlanePoint>& points, std::uint32_t at);

  std::uint32_t left_ = 0;       // points that are not cut off
  std::uint32_t cut_count_ = 0;  // triangles
  std::uint32_t next_[max_points], previous_[max_points];
  bool blocks_[max_points];            // flat or reflex: only such points can lie in an ear
  std::uint32_t blocker_[max_points];  // those points
  std::uint32_t blocker_count_ = 0;
  std::uint32_t inner_[max_points];  // the side cut between a point and the next, or none
  // The boxes around sides, twice.
  std::int32_t low_u_[2 * max_points], high_u_[2 * max_points];
  std::int32_t low_v_[2 * max_points], high_v_[2 * max_points];
};

}  // namespace discmc::meshing

#endif
