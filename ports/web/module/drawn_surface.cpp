#include "drawn_surface.hpp"

#include "meshes/lattice_plane.hpp"

namespace discmc::web {

void DrawnSurface::make(const meshing::Polygons& polygons) {
  vertices_.clear();
  for (std::vector<std::uint32_t>& triangles : triangles_of_) triangles.clear();
  edges_.clear();
  left_out_ = 0;
  number_ = 0;
  corners_.fill(polygons);
  for (const meshing::Polygon& polygon : polygons) {
    add_polygon(polygon);
    add_triangles(polygon.incidence);
  }
  gather_triangles();
}

void DrawnSurface::add_polygon(const meshing::Polygon& polygon) {
  points_.clear();
  ring_ends_.clear();
  first_vertex_ = static_cast<std::uint32_t>(vertices_.size());
  ++number_;
  for (const meshing::Ring& ring : polygon.rings) add_ring(ring, polygon);
}

void DrawnSurface::add_ring(const meshing::Ring& ring, const meshing::Polygon& polygon) {
  const meshing::LatticePlane plane(polygon.rings[0][0], polygon.incidence);
  const auto begin = static_cast<std::uint32_t>(vertices_.size());
  const auto add = [&](const Vertex& vertex) {
    vertices_.push_back(
        {static_cast<std::int16_t>(vertex.x), static_cast<std::int16_t>(vertex.y),
         static_cast<std::int16_t>(vertex.z), polygon.incidence,
         static_cast<std::uint8_t>((number_ * 0x9E3779B1u >> 16) % DrawnVertex::colours)});
    points_.push_back(plane.at(vertex));
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    add(ring[i]);
    const meshing::Side side =
        meshing::side_between(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    Vertex vertex = ring[i];
    for (std::int32_t link = 1; link < side.links; ++link) {
      vertex = vertex + side.link;
      if (corners_.holds(vertex)) add(vertex);
    }
  }
  const auto end = static_cast<std::uint32_t>(vertices_.size());
  for (std::uint32_t vertex = begin; vertex < end; ++vertex) {
    edges_.push_back(vertex);
    edges_.push_back(vertex + 1 < end ? vertex + 1 : begin);
  }
  ring_ends_.push_back(static_cast<std::uint32_t>(points_.size()));
}

void DrawnSurface::add_triangles(Incidence incidence) {
  const TriangleStore::Triangles triangles = store_.triangulate(points_, ring_ends_);
  if (triangles.count == 0) ++left_out_;
  for (std::size_t i = 0; i < triangles.count; ++i)
    for (const std::uint32_t corner : triangles.begin[i])
      triangles_of_[incidence].push_back(first_vertex_ + corner);
}

void DrawnSurface::gather_triangles() {
  triangles_.clear();
  triangle_ends_.clear();
  for (const std::vector<std::uint32_t>& triangles : triangles_of_) {
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    triangle_ends_.push_back(static_cast<std::uint32_t>(triangles_.size()));
  }
}

}  // namespace discmc::web
