#include "mesh_files.hpp"

#include <stdexcept>

namespace discmc::command {

void write_mesh(const FileMesh& mesh, Format format, std::ostream& out, unsigned jobs) {
  if (format == Format::stl) return write_stl(mesh, out, jobs);
  if (format == Format::ply) return write_ply(mesh, out, jobs);
  if (format == Format::obj) return write_obj(mesh, out, jobs);
  if (format == Format::vtp) return write_vtp(mesh, out);
  if (!traits_of(format).holds_several) throw std::invalid_argument("the format holds no meshes");
  write_meshes({&mesh}, format, out);
}

void write_meshes(const Meshes& meshes, Format format, std::ostream& out) {
  if (format == Format::glb) return write_glb(meshes, out);
  if (format == Format::three_mf) return write_3mf(meshes, out);
  if (format == Format::csv) return write_csv(meshes, out);
  if (format == Format::json) return write_json(meshes, out);
  if (meshes.size() != 1) throw std::invalid_argument("the format holds one mesh per file");
  write_mesh(*meshes[0], format, out);
}

}  // namespace discmc::command
