// discmc extract -o FILE.stl: a volume to meshes, one a surface.
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "exit_codes.hpp"
#include "extract.hpp"
#include "files/file_pattern.hpp"
#include "files/output_file.hpp"
#include "mesh_files/file_format.hpp"
#include "mesh_files/mesh_files.hpp"
#include "mesh_output.hpp"
#include "meshes/surface_normals.hpp"
#include "meshes/vertex_normals.hpp"
#include "progress.hpp"
#include "summary.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

void add_normals(const ExtractArguments& arguments, const Selection& selection,
                 const Surface& surface, Mesh& mesh) {
  if (arguments.normals == Normals::none) return;
  if (arguments.interpolates)
    mesh.normals = surface_normals(mesh);
  else
    set_polygon_normals(surface, mesh);
  if (arguments.normals == Normals::surface) return;
  const auto again =
      open_for_gradient(arguments.volume, volume_options(arguments.reading.layout), selection.low);
  add_gradient_normals(*again.reader, mesh);
}

MeshOptions options_of(const ExtractArguments& arguments, const SurfaceOutput& output) {
  MeshOptions options = arguments.mesh;
  options.crossings = output.crossings;
  options.jobs = jobs_of(arguments);
  return options;
}

// What a mesh gets before it is placed.
void complete(const ExtractArguments& arguments, const SurfaceOutput& output, Mesh& mesh) {
  note_left_out(arguments.volume, output.surface, mesh);
  add_normals(arguments, output.selection.selection, output.surface, mesh);
  mesh.colour = output.selection.colour;
}

}  // namespace

MeshSummary summary_of(const Mesh& mesh, const ExtractArguments& arguments) {
  MeshSummary summary{arguments.mesh.faces == Faces::triangles ? "triangles" : "polygons",
                      mesh.face_count(), mesh.vertices_mm.size()};
  if (!arguments.quiet) summary.is_closed = is_closed(mesh);
  return summary;
}

MeshSummary write_mesh_of(const ExtractArguments& arguments, const SurfaceOutput& output,
                          const std::optional<VolumePlacement>& placement) {
  OutputFile file(output.file);
  MeshSummary summary{"polygons", output.surface.polygons.size()};
  write_surface(
      output.surface, format_of(output.file), options_of(arguments, output),
      [&](Mesh& mesh) {
        complete(arguments, output, mesh);
        summary = summary_of(mesh, arguments);
      },
      placement, file);
  file.commit();
  return summary;
}

Mesh part_of(const ExtractArguments& arguments, const SurfaceOutput& output,
             const std::optional<VolumePlacement>& placement) {
  Mesh part = placed_mesh(
      output.surface, options_of(arguments, output),
      [&](Mesh& mesh) { complete(arguments, output, mesh); }, placement);
  part.name = output.selection.name;
  return part;
}

void write_parts(const ExtractArguments& arguments, const std::vector<Mesh>& parts) {
  Meshes meshes;
  for (const Mesh& part : parts) meshes.push_back(&part);
  OutputFile file(arguments.output);
  write_to(file,
           [&](std::ostream& out) { write_meshes(meshes, format_of(arguments.output), out); });
  file.commit();
}

int extract_meshes(const ExtractArguments& arguments) {
  if (arguments.normals == Normals::gradient) require_second_pass(arguments.volume, gradient_pass);
  const std::vector<NamedSelection>& selections = arguments.reading.selections;
  const FilePattern pattern(arguments.output);
  const auto volume = open_measured(arguments.volume, arguments.reading);
  const VolumeInfo& info = volume->info();
  const auto mask = open_noted_mask(arguments.reading, info);
  const auto placement = mesh_placement(arguments.volume, info.placement, arguments.space);
  pattern.require_folder();
  const bool is_shared = shares_file(arguments);
  const std::vector<std::string> files = files_for(pattern, selections);
  Progress progress("extracting", info.dims[2]);
  ExtractionOptions options = extraction_options(arguments.reading, progress, mask.get());
  if (is_divisible(arguments)) options.jobs = jobs_of(arguments);

  const SurfaceReceivers receivers = receivers_for(selections);
  for (const auto& receiver : receivers) receiver->start_surface();
  std::vector<SurfaceRequest> requests = requests_of(selections, receivers);
  std::vector<CrossingFinder> finders;
  if (arguments.interpolates)
    for (const NamedSelection& each : selections) finders.emplace_back(info, each.selection);
  for (std::size_t i = 0; i < finders.size(); ++i) requests[i].crossings = &finders[i];
  const std::vector<Extraction> extractions = extract(*volume, options, requests);
  note_not_numbers(arguments, extractions[0].not_numbers);
  check_surfaces(arguments, extractions, *volume);

  std::vector<Mesh> parts;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    Surface& surface = receivers[i]->surface();
    surface.spacing_mm = info.spacing_mm;
    keep_chosen(arguments.volume + (files.size() > 1 ? ": " + selections[i].name : ""),
                arguments.components, surface);
    if (surface.polygons.empty() && !arguments.reading.allows_empty)
      throw std::runtime_error(arguments.volume +
                               ": no body is as large as --min-volume says; give less, "
                               "--allow-empty takes an empty surface");
    const SurfaceOutput output{surface, selections[i], files[i],
                               arguments.interpolates ? &finders[i].crossings() : nullptr};
    if (is_shared) {
      parts.push_back(part_of(arguments, output, placement));
      surface = {};  // its memory is the next part's
      continue;
    }
    const MeshSummary mesh = write_mesh_of(arguments, output, placement);
    if (arguments.quiet) continue;
    write_file(files[i], std::cout);
    write_mesh_table(mesh, extractions[i], std::cout);
  }
  if (is_shared) {
    write_parts(arguments, parts);
    if (!arguments.quiet) write_file(arguments.output, std::cout);
    for (std::size_t i = 0; i < parts.size() && !arguments.quiet; ++i) {
      std::cout << parts[i].name << '\n';
      write_mesh_table(summary_of(parts[i], arguments), extractions[i], std::cout);
    }
  }
  if (!arguments.quiet) require_written(std::cout);
  return exit_ok;
}

}  // namespace discmc::command
