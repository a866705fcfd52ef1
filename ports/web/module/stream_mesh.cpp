#include "stream_mesh.hpp"

#include <utility>

#include "meshes/mesh.hpp"
#include "meshes/outline.hpp"
#include "meshes/surface_normals.hpp"
#include "smoothing/relaxed_crossings.hpp"

namespace discmc::web {
namespace {

void append(const meshing::Point& point, std::vector<float>& to) {
  for (const double coordinate : point) to.push_back(static_cast<float>(coordinate));
}

}  // namespace

void StreamMesh::make(const StreamSurface& stream, bool relaxes) {
  const meshing::Surface& surface = stream.surface();
  const meshing::StreamReader& reader = stream.reader();
  meshing::Crossings crossings(reader.dims(), surface.polygons);
  stream.fractions().place(crossings);
  const meshing::MeshingOptions options{true, meshing::Faces::triangles, &crossings};
  if (relaxes) meshing::relax(crossings, surface, {reader.header().border, options.tolerance, {}});
  meshing::FaceMesh mesh = meshing::build_mesh(surface, options);
  left_out_ = mesh.left_out.size();
  places_.clear();
  normals_.clear();
  for (const meshing::Point& at : mesh.vertices_mm) {
    const auto& spacing = surface.spacing_mm;
    append({2 * at[0] / spacing[0], 2 * at[1] / spacing[1], 2 * at[2] / spacing[2]}, places_);
  }
  for (const meshing::Point& normal : meshing::surface_normals(mesh)) append(normal, normals_);
  triangles_ = std::move(mesh.corners);
  if (!meshing::is_mirrored(surface.spacing_mm)) return;
  for (std::size_t i = 0; i < triangles_.size(); i += 3)
    std::swap(triangles_[i], triangles_[i + 2]);
}

}  // namespace discmc::web
