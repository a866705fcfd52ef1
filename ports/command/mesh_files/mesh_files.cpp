#include "mesh_files.hpp"

#include <stdexcept>

namespace discmc::command {

void write_mesh(const FileMesh& mesh, Format format, std::ostream& out, unsigned jobs) {
  switch (format) {
    case Format::stl:
      return write_stl(mesh, out, jobs);
    case Format::ply:
      return write_ply(mesh, out, jobs);
    case Format::obj:
      return write_obj(mesh, out, jobs);
    case Format::glb:
      return write_glb({&mesh}, out);
    case Format::three_mf:
      return write_3mf({&mesh}, out);
    case Format::vtp:
      return write_vtp(mesh, out);
    case Format::csv:
      return write_csv({&mesh}, out);
    case Format::json:
      return write_json({&mesh}, out);
    case Format::stream:
    case Format::jsonl:
      break;
  }
  throw std::invalid_argument("the format holds no meshes");
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
