#include "mesh_output.hpp"

#include <stdexcept>

#include "mesh_files/mesh_files.hpp"
#include "meshes/placing.hpp"
#include "meshes/vertex_normals.hpp"
#include "progress.hpp"
#include "text/say.hpp"

namespace discmc::command {
namespace {

Mesh triangulated(const Surface& surface, const MeshOptions& options) {
  const Progress triangulating("triangulating");
  return build_mesh(surface, options);
}

}  // namespace

std::optional<VolumePlacement> mesh_placement(const std::string& input,
                                              const std::optional<VolumePlacement>& told,
                                              const std::optional<MeshSpace>& asked) {
  if (asked == MeshSpace::voxel) return std::nullopt;
  if (!told || told->frame == Frame::none) {
    if (!asked) return told;
    throw std::invalid_argument(input +
                                ": it does not tell where the patient is: leave out --space, or "
                                "give --space voxel");
  }
  return in_frame(*told, asked == MeshSpace::ras ? Frame::ras : Frame::lps);
}

Mesh placed_mesh(const Surface& surface, const MeshOptions& options,
                 const std::function<void(Mesh&)>& add_normals,
                 const std::optional<VolumePlacement>& placement) {
  Mesh mesh = triangulated(surface, options);
  add_normals(mesh);
  if (placement) place(mesh, *placement);
  return mesh;
}

void write_to(OutputFile& file, const std::function<void(std::ostream&)>& write) {
  const Progress writing("writing");
  try {
    write(file.stream());
  } catch (const std::runtime_error&) {
    if (!file.stream()) file.commit();  // throws
    throw;
  }
}

void write_surface(const Surface& surface, Format format, const MeshOptions& options,
                   const std::function<void(Mesh&)>& add_normals,
                   const std::optional<VolumePlacement>& placement, OutputFile& file) {
  if (format == Format::jsonl)
    return write_to(file, [&](std::ostream& out) { write_jsonl(surface, out); });
  const Mesh mesh = placed_mesh(surface, options, add_normals, placement);
  write_to(file, [&](std::ostream& out) { write_mesh(mesh, format, out, options.jobs); });
}

void note_left_out(const std::string& input, const Surface& surface, const Mesh& mesh) {
  if (mesh.left_out.empty()) return;
  say(input, std::to_string(mesh.left_out.size()) + " of " +
                 std::to_string(surface.polygons.size()) +
                 " polygons left out, as their rings cross or bound nothing; -o FILE.jsonl has the "
                 "first in line " +
                 std::to_string(mesh.left_out[0] + 1));
}

void keep_chosen(const std::string& name, const ComponentChoice& choice, Surface& surface) {
  if (choice.is_any()) return;
  const Progress progress("choosing");
  const ComponentCounts counts = keep_components(surface, choice);
  if (counts.kept == counts.found) return;
  say(name, std::to_string(counts.kept) + " of " + std::to_string(counts.found) +
                " bodies and cavities kept");
}

void add_gradient_normals(VolumeReader& volume, Mesh& mesh) {
  Progress progress("normals", volume.info().dims[2]);
  set_gradient_normals(volume, mesh, [&progress](std::uint32_t slices) { progress.show(slices); });
}

}  // namespace discmc::command
