#include "extract_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>

#include "extract.hpp"
#include "files/file_pattern.hpp"
#include "mesh_files/file_format.hpp"
#include "mesh_files/file_mesh.hpp"
#include "mesh_files/mesh_files.hpp"
#include "mesh_output.hpp"
#include "meshes/surface_normals.hpp"
#include "meshes/vertex_normals.hpp"
#include "surface/polygon_crossings.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

void add_normals(const ExtractArguments& arguments, const Selection& selection,
                 const Surface& surface, FileMesh& mesh) {
  if (arguments.normals == Normals::none) return;
  if (mesh.polygons.empty() || arguments.surface != SurfaceKind::merged)
    mesh.normals = surface_normals(mesh);
  else
    set_polygon_normals(surface, mesh);
  if (arguments.normals == Normals::surface) return;
  const auto again = open_for_gradient(arguments.volume, arguments.reading.options, selection.low);
  add_gradient_normals(*again.reader, mesh);
}

// Many programs end the name of a material file at its first space.
std::filesystem::path material_file(const std::filesystem::path& mesh) {
  std::string name = mesh.filename().replace_extension(".mtl").string();
  std::replace(name.begin(), name.end(), ' ', '_');
  return mesh.parent_path() / name;
}

// OBJ keeps the colour of a mesh in a second file.
void write_obj_and_mtl(const FileMesh& mesh, const std::string& name, unsigned jobs,
                       OutputFile& file) {
  const auto materials = material_file(name);
  write_to(file,
           [&](std::ostream& out) { write_obj(mesh, out, jobs, materials.filename().string()); });
  file.commit();
  OutputFile beside(materials);
  write_to(beside, [&mesh](std::ostream& out) { write_mtl(*mesh.colour, out); });
  beside.commit();
}

Meshes pointers_to(const std::vector<FileMesh>& meshes) {
  Meshes pointers;
  for (const FileMesh& mesh : meshes) pointers.push_back(&mesh);
  return pointers;
}

std::int64_t count_voxels(const Surface& surface) {
  std::int64_t voxels = 0;
  for (const Polygon& polygon : surface.polygons) voxels += enclosed_voxels(polygon);
  return voxels;
}

MeshingOptions options_of(const ExtractArguments& arguments, const SurfaceOutput& output,
                          unsigned jobs) {
  MeshingOptions options = arguments.mesh;
  options.crossings = output.crossings;
  options.jobs = jobs;
  return options;
}

}  // namespace

MeshFiles::MeshFiles(const ExtractArguments& arguments) : arguments_(arguments) {
  require_no_terminal(arguments.output);
  const FilePattern pattern(arguments.output);
  if (pattern.has_name())
    pattern.require_folder();
  else
    file_.emplace(arguments.output);
}

std::vector<std::string> MeshFiles::names_for(const std::vector<NamedSelection>& selections) {
  const FilePattern pattern(arguments_.output);
  are_one_ =
      !pattern.has_name() && (selections.size() > 1 ||
                              (!arguments_.labels.empty() && !arguments_.reading.selects_labels()));
  if (!pattern.has_name()) return std::vector<std::string>(selections.size(), arguments_.output);
  std::vector<std::string> names;
  const bool is_obj = format_of(arguments_.output) == Format::obj;
  std::set<std::string> used_names;  // material files need distinct names, too
  for (const NamedSelection& each : selections) {
    std::string addition;
    const auto key = [&] {
      const std::string name = pattern.file_for(each.name, addition);
      return is_obj ? material_file(name).string() : name;
    };
    while (!used_names.insert(key()).second) addition += "-" + each.given;
    names.push_back(pattern.file_for(each.name, addition));
  }
  return names;
}

FileMesh MeshFiles::made(const SurfaceOutput& output, unsigned jobs) const {
  FileMesh mesh = triangulated(output.surface, options_of(arguments_, output, jobs));
  if (arguments_.decimation.is_wanted()) decimate(mesh, arguments_.decimation);
  return mesh;
}

void MeshFiles::make_ahead(SurfaceOutput& output) const {
  const bool is_written_later =
      format_of(output.file) == Format::jsonl || (!are_one_ && may_write_parts(output));
  if (!is_written_later && !arguments_.lists_bodies) output.made = made(output, 1);
}

MeshSummary MeshFiles::add(SurfaceOutput output) {
  MeshSummary summary = are_one_ ? keep(output) : write_alone(output);
  output.surface = {};  // frees memory for the next mesh
  return summary;
}

MeshSummary MeshFiles::write_alone(SurfaceOutput& output) {
  if (file_) return write(output, *file_);
  OutputFile file(output.file);
  return write(output, file);
}

MeshSummary MeshFiles::write(SurfaceOutput& output, OutputFile& file) const {
  if (const auto summary = write_parts(output, file)) return *summary;
  MeshSummary summary{"polygons", output.surface.polygons.size()};
  const Format format = format_of(output.file);
  if (format == Format::jsonl) {
    write_to(file, [&](std::ostream& out) { write_jsonl(output.surface, out); });
  } else {
    const std::vector<FileMesh> meshes = meshes_of(output);
    summary = summary_of(meshes);
    const FileMesh& mesh = meshes[0];
    if (format == Format::obj && mesh.colour && !is_standard_output(output.file)) {
      write_obj_and_mtl(mesh, output.file, jobs_of(arguments_), file);
      return summary;
    }
    write_to(file, [&](std::ostream& out) {
      if (arguments_.lists_bodies)
        write_meshes(pointers_to(meshes), format, out);
      else
        write_mesh(mesh, format, out, jobs_of(arguments_));
    });
  }
  file.commit();
  return summary;
}

// Whether the format and the options allow writing without a whole mesh in memory.
bool MeshFiles::may_write_parts(const SurfaceOutput& output) const {
  const Format format = format_of(output.file);
  return output.crossings == nullptr && !arguments_.decimation.is_wanted() &&
         arguments_.normals == Normals::none && !arguments_.lists_bodies &&
         (format == Format::stl || format == Format::ply);
}

// Writes without a whole mesh in memory, if the file and the options allow this.
std::optional<MeshSummary> MeshFiles::write_parts(const SurfaceOutput& output,
                                                  OutputFile& file) const {
  if (!may_write_parts(output) || !file.can_seek()) return std::nullopt;
  const MeshParts parts(output.surface, options_of(arguments_, output, jobs_of(arguments_)),
                        !arguments_.is_quiet, [&](FileMesh& part) {
                          place_in_file(part, placement_, arguments_.size);
                          part.colour = output.selection.colour;
                        });
  if (!suits_floats(parts.bounds())) return std::nullopt;
  MeshTotals totals;
  write_to(file, [&](std::ostream& out) {
    totals = format_of(output.file) == Format::stl ? write_stl(parts, out) : write_ply(parts, out);
  });
  note_left_out(output.title, output.surface, totals.left_out);
  file.commit();
  MeshSummary summary{name_of_faces(), totals.faces, parts.vertex_count()};
  if (!arguments_.is_quiet) summary.is_closed = totals.edge_sum == 0;
  return summary;
}

MeshSummary MeshFiles::keep(SurfaceOutput& output) {
  std::vector<FileMesh> meshes = meshes_of(output);
  const MeshSummary summary = summary_of(meshes);
  std::move(meshes.begin(), meshes.end(), std::back_inserter(meshes_));
  return summary;
}

void MeshFiles::finish() {
  if (!are_one_) return;
  write_to(*file_, [&](std::ostream& out) {
    write_meshes(pointers_to(meshes_), format_of(arguments_.output), out);
  });
  file_->commit();
  if (!arguments_.is_quiet) print_file(arguments_.output, table_stream(arguments_.output));
}

// Returns one mesh, or one mesh per body.
std::vector<FileMesh> MeshFiles::meshes_of(SurfaceOutput& output) const {
  std::vector<FileMesh> meshes;
  if (!arguments_.lists_bodies) {
    meshes.push_back(mesh_of(output));
    return meshes;
  }
  for (Surface& body : bodies(output.surface)) {
    SurfaceOutput alone{body, output.selection, output.file, output.title, output.crossings};
    meshes.push_back(mesh_of(alone));
    meshes.back().name += (meshes.back().name.empty() ? "" : " ") + std::to_string(meshes.size());
  }
  if (meshes.empty()) meshes.push_back(mesh_of(output));
  return meshes;
}

FileMesh MeshFiles::mesh_of(SurfaceOutput& output) const {
  if (!output.made) {
    std::optional<Progress> progress;
    if (arguments_.decimation.is_wanted()) progress.emplace("decimating");
    output.made = made(output, jobs_of(arguments_));
  }
  FileMesh mesh = std::move(*output.made);
  note_left_out(output.title, output.surface, mesh.left_out);
  note_decimated(output.title, arguments_.decimation, mesh.face_count());
  add_normals(arguments_, output.selection.selection, output.surface, mesh);
  place_in_file(mesh, placement_, arguments_.size);
  mesh.colour = output.selection.colour;
  note_rounding(output.file, mesh);
  const FormatTraits& traits = traits_of(format_of(output.file));
  if (are_one_ || traits.holds_measures) mesh.name = output.selection.name;
  if (traits.holds_measures && arguments_.reading.border == Border::closed)
    mesh.voxels = count_voxels(output.surface);
  return mesh;
}

MeshSummary MeshFiles::summary_of(const std::vector<FileMesh>& meshes) const {
  MeshSummary summary{name_of_faces()};
  bool is_closed = true;
  for (const FileMesh& mesh : meshes) {
    summary.face_count += mesh.face_count();
    summary.vertex_count += mesh.vertices_mm.size();
    is_closed = is_closed && (arguments_.is_quiet || is_closed_in(arguments_.output, mesh));
  }
  if (!arguments_.is_quiet) summary.is_closed = is_closed;
  return summary;
}

}  // namespace discmc::command
