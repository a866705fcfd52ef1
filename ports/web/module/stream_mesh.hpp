// The surface of a stream, with vertices moved off the midpoints between voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stream_surface.hpp"

namespace discmc::web {

/// A closed mesh without T-junctions, like that of MeshReceiver::mesh().
class StreamMesh {
 public:
  /// relaxes: as MeshOptions; otherwise interpolates by the fractions of the stream. Throws like
  /// Crossings and build_mesh().
  void make(const StreamSurface& stream, bool relaxes);

  /// Three per vertex. Units: half-steps.
  const std::vector<float>& places() const { return places_; }
  /// Three per vertex: unit vectors in space, outwards.
  const std::vector<float>& normals() const { return normals_; }
  /// Numbers of vertices, three per triangle, in the order of DrawnSurface::triangles().
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// The number of polygons that cannot be triangulated.
  std::size_t left_out() const { return left_out_; }

 private:
  std::vector<float> places_, normals_;
  std::vector<std::uint32_t> triangles_;
  std::size_t left_out_ = 0;
};

}  // namespace discmc::web
