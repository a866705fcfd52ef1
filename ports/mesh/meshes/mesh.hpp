// Converts polygons on the half-step lattice to a mesh in millimetres.
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

/// The maximum of a byte, which counts corners in PLY files.
constexpr std::size_t max_face_corners = 255;

enum class Faces {
  polygons,   ///< n-gons; polygons with holes or more than max_face_corners are triangulated
  triangles,  ///< triangles only
};

struct MeshingOptions {
  /// Whether to keep vertices on straight sides at which boundary links of other polygons end. The
  /// mesh then has no T-junctions. Without these vertices it is smaller, but only looks closed.
  bool is_conforming = true;
  Faces faces = Faces::polygons;
  /// Moves vertices to the places where samples cross the threshold: Crossings::interpolated().
  /// Faces then intersect only where the interpolated surface itself does. Limit: conforming
  /// triangles. Owner: the caller.
  const Crossings* crossings = nullptr;
  /// The largest distance of a crossing from the mesh. Larger distances split sides and triangles.
  /// Units: voxels.
  double tolerance = 0.05;
  /// The number of threads. The mesh does not depend on it. Limit: at least one.
  unsigned jobs = 1;
  /// Called regularly, if set, by one thread at a time. Its exceptions end the call.
  std::function<void()> check{};
  /// Whether intersecting faces of an interpolated mesh are split. Measuring a volume does not need
  /// this.
  bool separates = true;
};

/// Faces over shared vertices. Faces are counter-clockwise seen from outside.
struct FaceMesh {
  Point spacing_mm{};                      ///< as in Surface
  std::vector<Point> vertices_mm;          ///< one per corner of the surface; more if interpolated
  std::vector<Vertex> lattice;             ///< one per vertex: its position before it moved, or the
                                           ///< cell of a decimated vertex; otherwise empty
  std::vector<std::uint32_t> corners;      ///< vertex numbers, face after face
  std::vector<std::size_t> face_begin{0};  ///< face f: corners face_begin[f] to face_begin[f + 1]
  /// One per face; empty if faces are not lattice planes, or if the mesh has been placed.
  std::vector<Incidence> incidences;
  std::vector<std::uint32_t> polygons;  ///< one per face: its index in Surface::polygons
  /// One per vertex, or empty: unit vectors that point outside, or zero.
  std::vector<Point> normals;
  /// Indexes in Surface::polygons of polygons without a face here: invalid ones (Ring, Polygon),
  /// which cannot be triangulated.
  std::vector<std::uint32_t> left_out{};

  std::size_t face_count() const { return face_begin.size() - 1; }
  std::size_t face_size(std::size_t face) const { return face_begin[face + 1] - face_begin[face]; }
  const std::uint32_t* face(std::size_t face) const { return corners.data() + face_begin[face]; }
};

/// Makes a mesh of all polygons. Voxel (i, j, k) lies at (i, j, k) times the spacing. Throws
/// std::invalid_argument if a spacing is zero or not finite, or if the mesh exceeds the limits of
/// the options.
FaceMesh build_mesh(const Surface& surface, const MeshingOptions& options = {});

/// Returns the unit vector that points from on to off, for voxels of this spacing.
Point outward_normal(Incidence incidence, const Point& spacing_mm);

/// Returns a vector along the normal of a face, with its area as length. It is accurate even if
/// corners are collinear. Units: square millimetres.
Point area_vector(const FaceMesh& mesh, std::size_t face);
/// Likewise returns the vector of a ring. corners: `count` vertex numbers.
Point area_vector(const std::vector<Point>& vertices, const std::uint32_t* corners,
                  std::size_t count);

/// Returns the unit normal of a face, by its incidence if it has one; zero if the face has no area.
Point face_normal(const FaceMesh& mesh, std::size_t face);

/// The faults of a mesh. For a closed mesh, all members except `edges` are 0.
struct MeshReport {
  std::size_t edges = 0;               ///< undirected
  std::size_t open_edges = 0;          ///< used by one face
  std::size_t non_manifold_edges = 0;  ///< used by three faces or more
  std::size_t wrongly_oriented = 0;    ///< used by two faces in the same direction
  std::size_t degenerate_faces = 0;    ///< without area, or with a vertex twice

  bool is_closed() const {
    return open_edges + non_manifold_edges + wrongly_oriented + degenerate_faces == 0;
  }
};

MeshReport check_mesh(const FaceMesh& mesh);

/// Whether a face has no area, or has a vertex twice.
bool is_degenerate(const FaceMesh& mesh, std::size_t face);

/// Whether every edge is used as often in one direction as in the other, as in MeshReport. Compares
/// sums of hashes, so an open mesh passes once in 2^64. Time: n for n faces.
bool is_closed(const FaceMesh& mesh);

/// Returns the sum of hashes that is_closed() compares with zero. The sums of a mesh's parts add up
/// to its own. numbers: of the part's vertices in the whole mesh; empty: equal to the part's.
std::uint64_t edge_sum(const FaceMesh& part, const std::vector<std::uint32_t>& numbers = {});

}  // namespace discmc::meshing

#endif
