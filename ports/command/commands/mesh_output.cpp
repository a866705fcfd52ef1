#include "mesh_output.hpp"

#include <stdexcept>

#include "meshes/vertex_normals.hpp"
#include "progress.hpp"

namespace discmc::host {

void write_surface(const Surface& surface, Format format, bool conforming,
                   const std::function<void(Mesh&)>& add_normals, OutputFile& file) {
  try {
    write_surface(surface, format, conforming, add_normals, file.stream());
  } catch (const std::runtime_error&) {
    if (!file.stream()) file.commit();  // throws
    throw;
  }
}

void add_gradient_normals(VolumeReader& volume, Mesh& mesh) {
  Progress progress("normals: slice", volume.info().dims[2]);
  set_gradient_normals(volume, mesh, [&progress](std::uint32_t slices) { progress.show(slices); });
}

}  // namespace discmc::host
