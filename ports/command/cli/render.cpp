// discmc render: draws a picture of a stream or a volume.
#include <optional>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "empty_surface.hpp"
#include "extract.hpp"
#include "extraction/classic.hpp"
#include "extraction/crossings.hpp"
#include "extraction/extraction.hpp"
#include "files/output_file.hpp"
#include "mesh_files/file_mesh.hpp"
#include "mesh_files/mesh_reader.hpp"
#include "mesh_output.hpp"
#include "meshes/mesh.hpp"
#include "meshes/surface_normals.hpp"
#include "meshes/vertex_normals.hpp"
#include "pictures/picture.hpp"
#include "progress.hpp"
#include "stream_input.hpp"
#include "surface/joined_surface.hpp"
#include "text/message.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

// Returns a mesh with normals of the surface if smooth shading is requested. crossings: the places
// of its vertices, or null.
FileMesh mesh_to_draw(const RenderArguments& arguments, Surface& surface,
                      const Crossings* crossings) {
  keep_chosen(arguments.input, arguments.components, surface);
  const bool smooth = arguments.smooth;
  const Faces faces = smooth || crossings != nullptr ? Faces::triangles : Faces::polygons;
  FileMesh mesh = build_mesh(surface, {true, faces, crossings, arguments.tolerance});
  note_left_out(arguments.input, surface, mesh.left_out);
  if (!smooth || surface.normals.empty()) return mesh;
  mesh.normals = surface_normals(mesh);
  set_stream_normals(surface, mesh);
  return mesh;
}

// The gradient is normal to the surface only if a threshold alone divides the samples.
bool uses_gradient(const RenderArguments& arguments) {
  const VolumeArguments& reading = arguments.reading;
  return arguments.smooth && arguments.surface == SurfaceKind::merged && reading.median == 0 &&
         reading.mask.empty() && !reading.selections[0].has_upper_end();
}

// options: of the extraction. volume: not yet read; this function reads all of it.
FileMesh mesh_of_volume(const RenderArguments& arguments, MeasuredVolume& volume,
                        ExtractionOptions options) {
  options.normals = uses_gradient(arguments);
  std::unique_ptr<SliceReader> narrow;
  if (options.normals && !is_scanner_type(volume.info().type)) {
    narrow =
        narrowed_again(arguments.input, arguments.reading.options, options.selection.low, volume);
    options.selection = {0};
  }
  JoinedSurface joined;
  SliceReader& samples = narrow ? *narrow : static_cast<SliceReader&>(volume);
  std::optional<CrossingFinder> finder;
  SurfaceRequest request{options.selection, make_sink(joined)};
  if (arguments.surface == SurfaceKind::interpolated) {
    finder.emplace(samples.info(), options.selection);
    request.crossings = &*finder;
  }
  const Extraction extraction = extract(samples, options, {request})[0];
  check_surface(arguments.input, arguments.reading, arguments.reading.selections[0], volume,
                extraction);
  joined.surface().spacing_mm = volume.info().spacing_mm;
  if (arguments.surface != SurfaceKind::relaxed)
    return mesh_to_draw(arguments, joined.surface(), finder ? &finder->crossings() : nullptr);
  Crossings relaxed(volume.info().dims, joined.surface().polygons);
  relax_noted(relaxed, joined.surface(), options.border, arguments.tolerance);
  return mesh_to_draw(arguments, joined.surface(), &relaxed);
}

FileMesh volume_to_draw(RenderArguments arguments) {
  if (uses_gradient(arguments)) require_second_pass(arguments.input, gradient_pass);
  const auto volume = open_measured(arguments.input, arguments.reading);
  Progress progress("extracting", volume->info().dims[2]);
  const auto mask = open_noted_mask(arguments.reading, volume->info());
  const auto options = extraction_options(arguments.reading, progress, mask.get());
  if (!arguments.classic) return mesh_of_volume(arguments, *volume, options);
  FileMesh mesh = classic_mesh(*volume, options);
  if (mesh.face_count() == 0 && !arguments.reading.allows_empty)
    fail_empty(arguments.input, arguments.reading, arguments.reading.selections[0], *volume);
  return mesh;
}

std::vector<FileMesh> meshes_of_file(const std::string& file) {
  const Progress progress("reading");
  return read_meshes(file);
}

std::vector<FileMesh> meshes_of_labels(const RenderArguments& arguments) {
  ExtractArguments extraction;
  extraction.volume = arguments.input;
  extraction.reading = arguments.reading;
  extraction.labels = arguments.labels;
  extraction.components = arguments.components;
  extraction.normals = arguments.smooth ? Normals::surface : Normals::none;
  extraction.space = MeshSpace::voxel;
  return label_meshes(extraction);
}

// colours: receives the colour of each face.
FileMesh parts_to_draw(std::vector<FileMesh> parts, std::vector<Srgb>& colours) {
  for (const FileMesh& part : parts)
    colours.resize(colours.size() + part.face_count(),
                   part.colour.value_or(PictureOptions().colour));
  return joined(std::move(parts));
}

PictureOptions picture_options(const RenderArguments& arguments) {
  PictureOptions options;
  options.width = arguments.size[0];
  options.height = arguments.size[1];
  options.from = {arguments.view[0], arguments.view[1], arguments.view[2]};
  options.zoom = arguments.zoom;
  if (!arguments.at.empty()) options.at = {arguments.at[0], arguments.at[1], arguments.at[2]};
  options.shading = arguments.smooth ? Shading::smooth : Shading::flat;
  options.draws_outlines = arguments.draws_outlines;
  return options;
}

}  // namespace

int run_render(const RenderArguments& arguments) {
  OutputFile file(arguments.output);
  PictureOptions options = picture_options(arguments);
  FileMesh mesh;
  int code = exit_ok;
  if (arguments.kind == InputKind::mesh) {
    mesh = parts_to_draw(meshes_of_file(arguments.input), options.face_colours);
  } else if (!arguments.labels.empty()) {
    mesh = parts_to_draw(meshes_of_labels(arguments), options.face_colours);
  } else if (arguments.kind == InputKind::volume) {
    RenderArguments found = arguments;
    found.reading.selections = with_thresholds(arguments.input, arguments.reading);
    mesh = volume_to_draw(found);
  } else {
    DecodedStream decoded = decode_surface(arguments.input, arguments.choice);
    note_empty(arguments.input, decoded);
    const std::optional<Crossings> crossings =
        crossings_of(arguments.input, decoded, arguments.surface, arguments.tolerance);
    mesh = mesh_to_draw(arguments, decoded.surface, crossings ? &*crossings : nullptr);
    code = completeness(arguments.input, decoded.report);
  }
  if (arguments.smooth && mesh.normals.empty()) mesh.normals = surface_normals(mesh);
  const Progress drawing("drawing");
  const Picture picture = draw(mesh, options);
  if (!picture.shows_mesh && mesh.face_count() > 0)
    print_message(output_display_name(arguments.output),
                  "no part of the surface is in the picture; change --at or --zoom");
  write_picture(picture, file.stream());
  file.commit();
  return code;
}

}  // namespace discmc::command
