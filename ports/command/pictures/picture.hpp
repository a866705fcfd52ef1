// A picture of a mesh, without a window or a graphics card.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "srgb.hpp"

namespace discmc::command {

enum class Projection { orthographic, perspective };

enum class Shading {
  flat,  ///< every face in one colour, by its normal
  /// The normals of the vertices are interpolated over the faces. A vertex normal more than 72
  /// degrees from the face's marks an edge: there the face's own normal counts. Limit: the mesh has
  /// triangles only, and normals.
  smooth,
};

struct PictureOptions {
  int width = 1024;                ///< Units: pixels. Limit: 1 to 8192
  int height = 1024;               ///< as width
  Point from = {-0.9, -1.6, 0.8};  ///< from the mesh to the viewer; any length but zero
  Point up = {0, 0, 1};            ///< points upwards in the picture
  Projection projection = Projection::perspective;
  double zoom = 1;          ///< 1 fills the picture; more is nearer. Limit: 1e-3 to 1e3
  std::optional<Point> at;  ///< in the middle of the picture; without it all of the mesh is
  Shading shading = Shading::flat;
  bool draws_outlines = false;       ///< thin dark lines around the merged polygons
  Srgb colour = {224, 186, 146};     ///< of the surface
  std::vector<Srgb> face_colours{};  ///< one per face in place of it, or none
};

/// Rows from top to bottom, three bytes (red, green, blue; sRGB) a pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
  bool shows_mesh = false;  ///< whether any part of the mesh lies in the picture
};

/// Draws the mesh so that it fills the picture but for a small margin. n-gons need not be convex.
/// The inside of an open mesh is drawn in a bluish tone.
/// Throws std::invalid_argument when the options are out of range or the mesh lacks what they ask.
Picture draw(const FaceMesh& mesh, const PictureOptions& options = {});

/// Writes a PNG file.
void write_picture(const Picture& picture, std::ostream& out);

}  // namespace discmc::command
