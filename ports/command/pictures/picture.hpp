// Draws a picture of a mesh without a window or a graphics card.
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
  flat,  ///< one colour per face, by its normal
  /// Vertex normals are interpolated over the faces. A vertex normal more than 72 degrees from the
  /// face's marks an edge, where the face's own normal replaces it. Limit: a mesh of triangles with
  /// normals.
  smooth,
};

struct PictureOptions {
  int width = 1024;                ///< Units: pixels. Limit: 1 to 8192
  int height = 1024;               ///< as width
  Point from = {-0.9, -1.6, 0.8};  ///< direction from the mesh to the viewer; not zero
  Point up = {0, 0, 1};            ///< direction that points upwards in the picture
  Projection projection = Projection::perspective;
  double zoom = 1;          ///< 1 fills the picture; larger values enlarge. Limit: 1e-3 to 1e3
  std::optional<Point> at;  ///< middle of the picture; default: middle of the mesh
  Shading shading = Shading::flat;
  bool draws_outlines = false;       ///< thin dark lines around the merged polygons
  Srgb colour = {224, 186, 146};     ///< of the surface
  std::vector<Srgb> face_colours{};  ///< one per face, replacing `colour`; or empty
};

/// Rows from top to bottom, three bytes (red, green, blue; sRGB) per pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
  bool shows_mesh = false;  ///< whether any part of the mesh lies in the picture
};

/// Draws the mesh so that it fills the picture except for a small margin. Polygons need not be
/// convex. The inside of an open mesh is bluish. Throws std::invalid_argument if the options are
/// out of range or the mesh lacks what they need.
Picture draw(const FaceMesh& mesh, const PictureOptions& options = {});

/// Writes a PNG file.
void write_picture(const Picture& picture, std::ostream& out);

}  // namespace discmc::command
