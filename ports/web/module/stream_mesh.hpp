// The surface of a stream, with its vertices off the middles between voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stream_surface.hpp"

namespace discmc::web {

/// A closed mesh without T-junctions, as MeshReceiver::mesh() makes it.
class StreamMesh {
 public:
  /// relaxes: as MeshOptions; else it interpolates by the fractions of the stream. Throws as
  /// Crossings and build_mesh().
  void make(const StreamSurface& stream, bool relaxes);

  /// Three a vertex. Units: half-steps.
  const std::vector<float>& places() const { return places_; }
  /// Three a vertex: unit vectors in space, outwards.
  const std::vector<float>& normals() const { return normals_; }
  /// Numbers of vertices, three a triangle, in the order of DrawnSurface::triangles().
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// How many polygons cannot be triangulated.
  std::size_t left_out() const { return left_out_; }

 private:
  std::vector<float> places_, normals_;
  std::vector<std::uint32_t> triangles_;
  std::size_t left_out_ = 0;
};

}  // namespace discmc::web
