// From polygons on the half-step lattice to a mesh in millimetres.
#ifndef DISCMC_MESH_MESHES_MESH_HPP
#define DISCMC_MESH_MESHES_MESH_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "surface/point.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

class Crossings;

/// What a byte can count, as in PLY files.
constexpr std::size_t max_face_corners = 255;

enum class Faces {
  polygons,   ///< n-gons; polygons with holes or more than max_face_corners are triangulated
  triangles,  ///< triangles only
};

struct MeshingOptions {
  /// Keep the vertices on straight sides where boundary links of other polygons end. The mesh then
  /// has no T-junctions. Without them it is smaller and only looks closed.
  bool is_conforming = true;
  Faces faces = Faces::polygons;
  /// Moves the vertices to where the samples cross the threshold: Crossings::interpolated(). Faces
  /// then go through each other only where the interpolated surface does so itself. Limit:
  /// triangles, conforming. Owner: the caller.
  const Crossings* crossings = nullptr;
  /// How far a crossing may be from the mesh then: where it would be farther, sides and triangles
  /// are split. Units: voxels.
  double tolerance = 0.05;
  /// This many threads triangulate polygons; of an interpolated mesh they find where it intersects
  /// itself. The mesh is the same.
  unsigned jobs = 1;
  /// Called now and then, by one thread at a time, if it is given. What it throws ends the call.
  std::function<void()> check{};
  /// Whether faces of an interpolated mesh are split if they go through each other: false where
  /// only the volume is measured.
  bool separates = true;
};

/// Faces over shared vertices. Faces are counter-clockwise seen from outside.
struct FaceMesh {
  Point spacing_mm{};                      ///< as in Surface
  std::vector<Point> vertices_mm;          ///< one for each corner of the surface, and more of an
                                           ///< interpolated one
  std::vector<Vertex> lattice;             ///< one per vertex: its position before it was moved, if
                                           ///< it was; the cell of a decimated one; none in others
  std::vector<std::uint32_t> corners;      ///< vertex numbers, face after face
  std::vector<std::size_t> face_begin{0};  ///< face f: corners face_begin[f] to face_begin[f + 1]
  /// One per face; none where faces lie in any plane, or the mesh has been placed.
  std::vector<Incidence> incidences;
  std::vector<std::uint32_t> polygons;  ///< one per face: its place in Surface::polygons
  /// One per vertex, or none at all: unit vectors that point outside, zero where there is none.
  std::vector<Point> normals;
  /// Places in Surface::polygons of those that have no face here: they are not valid (Ring,
  /// Polygon) and cannot be triangulated.
  std::vector<std::uint32_t> left_out{};

  std::size_t face_count() const { return face_begin.size() - 1; }
  std::size_t face_size(std::size_t face) const { return face_begin[face + 1] - face_begin[face]; }
  const std::uint32_t* face(std::size_t face) const { return corners.data() + face_begin[face]; }
};

/// Makes a mesh of all polygons. Voxel (i, j, k) lies at (i, j, k) times the spacing.
/// Throws std::invalid_argument when a spacing is zero or not finite, or beyond the limits of the
/// options.
FaceMesh build_mesh(const Surface& surface, const MeshingOptions& options = {});

/// The unit vector that points from on to off where the voxels have this spacing.
Point outward_normal(Incidence incidence, const Point& spacing_mm);

/// A vector along the normal of a face, as long as the face is large; exact enough also where
/// corners are collinear. Units: square millimetres.
Point area_vector(const FaceMesh& mesh, std::size_t face);
/// The same of a ring. corners: `count` numbers of vertices.
Point area_vector(const std::vector<Point>& vertices, const std::uint32_t* corners,
                  std::size_t count);

/// The unit normal of a face, by its incidence where it has one; zero where it has no area.
Point face_normal(const FaceMesh& mesh, std::size_t face);

/// What is wrong with a mesh. A closed mesh has zero everywhere but in `edges`.
struct MeshReport {
  std::size_t edges = 0;               ///< undirected
  std::size_t open_edges = 0;          ///< used by one face
  std::size_t non_manifold_edges = 0;  ///< used by three faces or more
  std::size_t wrongly_oriented = 0;    ///< used by two faces in the same direction
  std::size_t degenerate_faces = 0;    ///< no area, or a vertex twice

  bool closed() const {
    return open_edges + non_manifold_edges + wrongly_oriented + degenerate_faces == 0;
  }
};

MeshReport check_mesh(const FaceMesh& mesh);

/// Whether a face has no area, or a vertex twice.
bool is_degenerate(const FaceMesh& mesh, std::size_t face);

/// Whether every edge is used in one direction as often as in the other, as in MeshReport, in time
/// n for n faces. Compares sums of hashes, so an open mesh passes once in 2^64.
bool is_closed(const FaceMesh& mesh);

/// The sum of hashes that is_closed() compares with zero. Sums of parts of a mesh add up to its
/// own. numbers: of the vertices in the whole mesh; the same as in the part if none are given.
std::uint64_t edge_sum(const FaceMesh& part, const std::vector<std::uint32_t>& numbers = {});

}  // namespace discmc::meshing

#endif
