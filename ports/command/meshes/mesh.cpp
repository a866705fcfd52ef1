#include "mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "lattice_plane.hpp"
#include "refinement.hpp"
#include "triangulate.hpp"

namespace discmc::host {
namespace {

// The lattice positions of a surface, numbered, and the number at every place of every ring.
class Numbering {
 public:
  explicit Numbering(const Surface& surface) {
    for (const Polygon& polygon : surface.polygons)
      for (const Ring& ring : polygon.rings)
        for (const Vertex& vertex : ring) {
          const auto next = static_cast<std::uint32_t>(positions_.size());
          const auto [entry, is_new] = numbers_.try_emplace(vertex, next);
          if (is_new) positions_.push_back(vertex);
          in_order_.push_back(entry->second);
        }
  }

  const std::vector<Vertex>& positions() const { return positions_; }
  const std::vector<std::uint32_t>& in_order() const { return in_order_; }

 private:
  std::unordered_map<Vertex, std::uint32_t, VertexHash> numbers_;
  std::vector<Vertex> positions_;
  std::vector<std::uint32_t> in_order_;
};

std::uint64_t undirected(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

// Where three or more boundary links end, some side ends as well, in whichever ring it is.
std::vector<bool> junctions(const Surface& surface, const Numbering& numbering) {
  std::vector<std::uint64_t> ends;
  ends.reserve(numbering.in_order().size());
  const std::uint32_t* number = numbering.in_order().data();
  for (const Polygon& polygon : surface.polygons)
    for (const Ring& ring : polygon.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        ends.push_back(undirected(number[i], number[(i + 1) % ring.size()]));
      number += ring.size();
    }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  std::vector<std::uint32_t> degrees(numbering.positions().size(), 0);
  for (const std::uint64_t end : ends) {
    ++degrees[end >> 32];
    ++degrees[end & 0xFFFFFFFFu];
  }
  std::vector<bool> result(degrees.size());
  std::transform(degrees.begin(), degrees.end(), result.begin(),
                 [](std::uint32_t degree) { return degree >= 3; });
  return result;
}

bool turns(const Ring& ring, std::size_t i) {
  const std::size_t count = ring.size();
  const Vertex& here = ring[i];
  return here - ring[(i + count - 1) % count] != ring[(i + 1) % count] - here;
}

class Builder {
 public:
  Builder(const Surface& surface, const MeshOptions& options)
      : surface_(surface), options_(options), numbering_(surface) {
    if (options.crossings != nullptr) refinement_.emplace(*options.crossings, options.tolerance);
    mesh_.spacing_mm = surface.spacing_mm;
    const Point& s = surface.spacing_mm;
    mirrored_ = (s[0] < 0) != ((s[1] < 0) != (s[2] < 0));
    if (options.conforming) junctions_ = junctions(surface, numbering_);
    if (refinement_) keep_what_sides_need();
    mesh_numbers_.assign(numbering_.positions().size(), not_in_mesh);
  }

  Mesh build() {
    const std::uint32_t* number = numbering_.in_order().data();
    for (std::size_t i = 0; i < surface_.polygons.size(); ++i) {
      const Polygon& polygon = surface_.polygons[i];
      numbers_.clear();
      ring_ends_.clear();
      for (const Ring& ring : polygon.rings) {
        keep(ring, number);
        number += ring.size();
      }
      add_polygon(static_cast<std::uint32_t>(i), polygon.incidence);
    }
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t not_in_mesh = 0xFFFFFFFFu;

  bool is_kept(const Ring& ring, const std::uint32_t* numbers, std::size_t i) const {
    return turns(ring, i) || (options_.conforming && junctions_[numbers[i]]);
  }

  void keep(const Ring& ring, const std::uint32_t* numbers) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (is_kept(ring, numbers, i)) numbers_.push_back(numbers[i]);
    ring_ends_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  }

  // What an interpolated side needs is kept as junctions are, by both polygons that have it.
  void keep_what_sides_need() {
    std::vector<bool> kept = junctions_;
    const std::uint32_t* numbers = numbering_.in_order().data();
    for (const Polygon& polygon : surface_.polygons)
      for (const Ring& ring : polygon.rings) {
        std::size_t begin = 0;
        while (begin < ring.size() && !is_kept(ring, numbers, begin)) ++begin;
        const std::size_t around = begin + ring.size();
        for (std::size_t end = begin + 1; end <= around; ++end) {
          if (!is_kept(ring, numbers, end % ring.size())) continue;
          keep_what_side_needs(ring, numbers, begin, end, kept);
          begin = end;
        }
        numbers += ring.size();
      }
    junctions_ = std::move(kept);
  }

  void keep_what_side_needs(const Ring& ring, const std::uint32_t* numbers, std::size_t begin,
                            std::size_t end, std::vector<bool>& kept) {
    if (end - begin < 2) return;
    side_.clear();
    for (std::size_t i = begin; i <= end; ++i) side_.push_back(ring[i % ring.size()]);
    const bool is_reversed = precedes(side_.back(), side_.front());
    if (is_reversed) std::reverse(side_.begin(), side_.end());
    for (const std::size_t i : refinement_->needed(side_))
      kept[numbers[(is_reversed ? end - i : begin + i) % ring.size()]] = true;
  }

  void add_polygon(std::uint32_t polygon, Incidence incidence) {
    const bool is_whole = options_.faces == Faces::polygons && ring_ends_.size() == 1 &&
                          numbers_.size() >= 3 && numbers_.size() <= max_face_corners;
    if (is_whole) return add_face(polygon, incidence, numbers_);
    try {
      add_triangles(polygon, incidence);
    } catch (const std::invalid_argument&) {
      mesh_.left_out.push_back(polygon);
    }
  }

  void add_triangles(std::uint32_t polygon, Incidence incidence) {
    const std::vector<Vertex>& positions = numbering_.positions();
    if (numbers_.empty()) throw std::invalid_argument("no corners");
    const LatticePlane plane(positions[numbers_[0]], incidence);
    points_.clear();
    for (const std::uint32_t number : numbers_) points_.push_back(plane.at(positions[number]));
    const std::vector<Triangle>& triangles = triangulator_.triangulate(points_, ring_ends_);
    if (refinement_) return add_refined(polygon, plane, triangles);
    for (const Triangle& triangle : triangles)
      add_face(polygon, incidence,
               std::array{numbers_[triangle[0]], numbers_[triangle[1]], numbers_[triangle[2]]});
  }

  void add_refined(std::uint32_t polygon, const LatticePlane& plane,
                   const std::vector<Triangle>& triangles) {
    for (std::uint32_t& number : numbers_) number = mesh_number(number);
    refined_.points = points_;
    refined_.moved.clear();
    for (const std::uint32_t number : numbers_) refined_.moved.push_back(moved_[number]);
    refined_.triangles = triangles;
    refinement_->refine(plane, refined_);
    for (std::size_t i = numbers_.size(); i < refined_.points.size(); ++i)
      numbers_.push_back(add_vertex(plane.vertex(refined_.points[i]), refined_.moved[i]));
    for (const Triangle& triangle : refined_.triangles) {
      for (std::size_t i = 0; i < 3; ++i)
        mesh_.corners.push_back(numbers_[triangle[mirrored_ ? 2 - i : i]]);
      mesh_.face_begin.push_back(mesh_.corners.size());
      mesh_.polygons.push_back(polygon);
    }
  }

  template <class Numbers>
  void add_face(std::uint32_t polygon, Incidence incidence, const Numbers& numbers) {
    const std::size_t count = numbers.size();
    for (std::size_t i = 0; i < count; ++i)
      mesh_.corners.push_back(mesh_number(numbers[mirrored_ ? count - 1 - i : i]));
    mesh_.face_begin.push_back(mesh_.corners.size());
    mesh_.incidences.push_back(incidence);
    mesh_.polygons.push_back(polygon);
  }

  std::uint32_t mesh_number(std::uint32_t number) {
    std::uint32_t& result = mesh_numbers_[number];
    if (result != not_in_mesh) return result;
    const Vertex& vertex = numbering_.positions()[number];
    if (refinement_) return result = add_vertex(vertex, refinement_->moved(vertex));
    const auto x = static_cast<double>(vertex.x), y = static_cast<double>(vertex.y),
               z = static_cast<double>(vertex.z);
    return result = add_vertex(vertex, {x, y, z});
  }

  // at: in half-steps.
  std::uint32_t add_vertex(const Vertex& vertex, const Point& at) {
    const Point& s = surface_.spacing_mm;
    mesh_.lattice.push_back(vertex);
    if (refinement_) moved_.push_back(at);
    mesh_.vertices_mm.push_back({at[0] * s[0] / 2, at[1] * s[1] / 2, at[2] * s[2] / 2});
    return static_cast<std::uint32_t>(mesh_.vertices_mm.size() - 1);
  }

  const Surface& surface_;
  const MeshOptions options_;
  const Numbering numbering_;
  std::optional<Refinement> refinement_;  // of an interpolated mesh
  bool mirrored_;
  std::vector<bool> junctions_;
  std::vector<std::uint32_t> mesh_numbers_;
  // Of the polygon under way: its kept vertices, ring after ring.
  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint32_t> ring_ends_;
  std::vector<PlanePoint> points_;
  Triangulator triangulator_;
  // Of an interpolated mesh: the side under way.
  std::vector<Vertex> side_;
  MovedTriangles refined_;
  std::vector<Point> moved_;  // of every vertex of the mesh; Units: half-steps
  Mesh mesh_;
};

}  // namespace

Mesh build_mesh(const Surface& surface, const MeshOptions& options) {
  for (const double spacing : surface.spacing_mm)
    if (spacing == 0 || !std::isfinite(spacing))
      throw std::invalid_argument("spacing is zero or not finite");
  const bool are_conforming_triangles = options.conforming && options.faces == Faces::triangles;
  if (options.crossings != nullptr && !are_conforming_triangles)
    throw std::invalid_argument("an interpolated mesh is one of conforming triangles");
  return Builder(surface, options).build();
}

Point outward_normal(Incidence incidence, const Point& spacing_mm) {
  // Planes transform by the inverse; a signed inverse also keeps the normal outside.
  const Vertex n = normal(incidence);
  const Point scaled = {n.x / spacing_mm[0], n.y / spacing_mm[1], n.z / spacing_mm[2]};
  const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

Point area_vector(const Mesh& mesh, std::size_t face) {
  const std::uint32_t* corners = mesh.face(face);
  const Point& origin = mesh.vertices_mm[corners[0]];
  Point sum{};
  for (std::size_t i = 2; i < mesh.face_size(face); ++i) {
    const Point doubled = cross(difference(mesh.vertices_mm[corners[i - 1]], origin),
                                difference(mesh.vertices_mm[corners[i]], origin));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += doubled[axis] / 2;
  }
  return sum;
}

Point face_normal(const Mesh& mesh, std::size_t face) {
  return mesh.incidences.empty() ? unit_or_zero(area_vector(mesh, face))
                                 : outward_normal(mesh.incidences[face], mesh.spacing_mm);
}

Ring corners_of(const Ring& ring) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (turns(ring, i)) result.push_back(ring[i]);
  return result;
}

}  // namespace discmc::host
