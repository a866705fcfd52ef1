#include "mesh_output.hpp"

#include <stdexcept>

#include "mesh_files/file_format.hpp"
#include "mesh_files/mesh_files.hpp"
#include "meshes/placing.hpp"
#include "meshes/vertex_normals.hpp"
#include "progress.hpp"
#include "smoothing/relaxed_crossings.hpp"
#include "text/message.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

// Returns the origin of the file's coordinates, if they are 32-bit floats.
std::optional<Point> origin_of_floats(const std::string& file, const FileMesh& mesh) {
  const Format format = format_of(file);
  if (traits_of(format).holds_doubles) return std::nullopt;
  return format == Format::glb ? glb_origin({&mesh}) : Point{};
}

}  // namespace

std::optional<VolumePlacement> mesh_placement(const std::string& input,
                                              const std::optional<VolumePlacement>& placement,
                                              const std::optional<MeshSpace>& asked) {
  if (asked == MeshSpace::voxel) return std::nullopt;
  if (!placement || placement->space == Space::scanner) {
    if (!asked) return placement;
    throw std::invalid_argument(
        input +
        ": the volume has no patient orientation; leave out --space, or give --space voxel");
  }
  return in_space(*placement, asked == MeshSpace::ras ? Space::ras : Space::lps);
}

FileMesh triangulated(const Surface& surface, const MeshingOptions& options) {
  const Progress triangulating("triangulating");
  return build_mesh(surface, options);
}

void relax_noted(Crossings& crossings, const Surface& surface, Border border, double tolerance) {
  const Progress smoothing("smoothing");
  relax(crossings, surface, {border, tolerance, {}});
}

void place_in_file(FileMesh& mesh, const std::optional<VolumePlacement>& placement,
                   const MeshSize& size) {
  if (placement) {
    place(mesh, *placement);
    mesh.space = placement->space;
  }
  if (size.is_given()) resize(mesh, size);
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

bool is_closed_in(const std::string& file, const FileMesh& mesh) {
  if (!is_closed(mesh)) return false;
  const std::optional<Point> origin = origin_of_floats(file, mesh);
  return !origin || suits_floats(mesh, *origin) ||
         count_float_places(mesh, *origin) == mesh.vertices_mm.size();
}

void note_rounding(const std::string& file, const FileMesh& mesh) {
  const std::optional<Point> origin = origin_of_floats(file, mesh);
  if (!origin || suits_floats(mesh, *origin)) return;
  const std::size_t places = count_float_places(mesh, *origin);
  std::string text = "coordinates are rounded to " + short_number(float_step_mm(mesh, *origin)) +
                     " " + names_of(mesh.unit).symbol + ", as " +
                     std::string(traits_of(format_of(file)).extension) +
                     " files hold 32-bit floats";
  if (places < mesh.vertices_mm.size())
    text += ", and " + std::to_string(mesh.vertices_mm.size()) + " vertices share " +
            std::to_string(places) + " places";
  text += "; write " + extensions(&FormatTraits::holds_doubles);
  if (suits_floats(mesh, mesh.vertices_mm[0])) text += ", or give --space voxel";
  print_message(output_display_name(file), text);
}

void note_left_out(const std::string& input, const Surface& surface,
                   const std::vector<std::uint32_t>& left_out) {
  if (left_out.empty()) return;
  print_message(input, std::to_string(left_out.size()) + " of " +
                           std::to_string(surface.polygons.size()) +
                           " polygons are invalid (their rings cross or enclose no area) and left "
                           "out; the first is in -o FILE.jsonl, line " +
                           std::to_string(left_out[0] + 1));
}

void keep_chosen(const std::string& name, const ComponentChoice& choice, Surface& surface) {
  if (choice.keeps_all()) return;
  const Progress progress("choosing");
  const ComponentCounts counts = keep_components(surface, choice);
  if (counts.kept == counts.found) return;
  print_message(name, std::to_string(counts.kept) + " of " + std::to_string(counts.found) +
                          " bodies and cavities are kept");
}

void note_decimated(const std::string& name, const Decimation& decimation, std::size_t triangles) {
  if (decimation.triangles == 0 || triangles <= decimation.triangles) return;
  print_message(name, "--triangles " + std::to_string(decimation.triangles) + ": the mesh has " +
                          std::to_string(triangles) +
                          (decimation.max_error_mm > 0
                               ? " triangles, because fewer would exceed --max-error"
                               : " triangles, because with fewer bodies or openings would be lost, "
                                 "or triangles would cross"));
}

void add_gradient_normals(SliceReader& volume, FileMesh& mesh) {
  Progress progress("normals", volume.info().dims[2]);
  set_gradient_normals(volume, mesh, [&progress](std::uint32_t slices) { progress.show(slices); });
}

}  // namespace discmc::command
