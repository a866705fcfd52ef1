// The colours of a mesh's faces in a picture.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "picture.hpp"

namespace discmc::command {

using Colour = std::array<float, 3>;  // linear light

/// Axes of the viewer: right, upwards, and out of the picture.
struct Axes {
  Point right, upward, towards;
};

/// A vertex in the picture: x to the right and y downwards in samples, and a nearness, which grows
/// towards the viewer. Nearness is linear over the picture of a plane. A value that is linear over
/// a plane in space, multiplied by the weight, is linear over the plane's picture.
struct Projected {
  double x, y, nearness, weight;
};

/// Lights the samples of a picture, face after face.
class Shader {
 public:
  /// Owner: the mesh, the vertices and the options outlive the shader.
  Shader(const FaceMesh& mesh, const std::vector<Projected>& vertices, const Axes& axes,
         const PictureOptions& options);

  /// Returns the colour of a face at a place of the picture. is_inside: the viewer sees the back of
  /// the face. Cost: less if the face is the same as in the last call.
  Colour colour(std::size_t face, bool is_inside, double x, double y);

 private:
  void begin_face(std::size_t face);
  Point normal_at(double x, double y) const;
  Colour light(const Point& normal, bool is_inside) const;

  const FaceMesh& mesh_;
  const std::vector<Projected>& vertices_;
  Axes axes_;
  Shading shading_;
  const std::vector<Srgb>& face_colours_;
  Colour surface_;  // of the current face
  // The main light comes over the viewer's left shoulder; the axes are right, upward, towards.
  Point key_light_ = unit_or_zero({-0.6, 0.7, 0.5});
  std::size_t face_;
  Point face_normal_{};
  std::array<Point, 3> normals_{};  // of the corners of the current face
};

}  // namespace discmc::command
