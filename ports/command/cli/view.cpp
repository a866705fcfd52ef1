// discmc view: a page that shows a volume, a stream or a mesh.
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "commands.hpp"
#include "extract.hpp"
#include "files/file_pattern.hpp"
#include "files/output_file.hpp"
#include "files/write_failure.hpp"
#include "input_content.hpp"
#include "mesh_files/mesh_files.hpp"
#include "mesh_files/mesh_reader.hpp"
#include "mesh_output.hpp"
#include "meshes/surface_normals.hpp"
#include "pages/browser.hpp"
#include "pages/page.hpp"
#include "pictures/picture.hpp"
#include "progress.hpp"
#include "stream_input.hpp"
#include "summary.hpp"
#include "text/message.hpp"
#include "view.hpp"
#include "volume_input.hpp"
#include "volumes/formats/nifti/writer.hpp"

namespace discmc::command {
namespace {

// Browsers hold less than 2^29 characters of text, and three incompressible bytes take four of
// them.
constexpr std::uint64_t page_bytes = std::uint64_t{1} << 28;

void write_page_of_samples(const ViewArguments& arguments, std::ostream& out) {
  const auto volume = open_noted(arguments.input, arguments.reading.options);
  require_size(arguments.input, volume->info(), page_bytes);
  Progress progress("writing", volume->info().dims[2]);
  write_page(
      name_of(arguments.input),
      [&](std::ostream& data) {
        write_nifti(
            *volume, [&progress](std::uint32_t slices) { progress.show(slices); }, data);
      },
      out);
}

int write_page_of_bytes(const NamedBytes& file, std::ostream& out) {
  const Progress progress("writing");
  write_page(
      file.name, [&file](std::ostream& data) { data << file.bytes; }, out);
  return file.code;
}

int write_page_of(const ViewArguments& arguments, std::ostream& out) {
  if (shows_meshes(arguments))
    return write_page_of_bytes(meshes_to_show(arguments, page_bytes), out);
  std::optional<ReplayedInput> replayed;
  const bool is_volume = arguments.kind ? arguments.kind == InputKind::volume
                                        : begins_like_volume(arguments.input, replayed);
  if (!is_volume) return write_page_of_bytes(stream_in_file(arguments), out);
  if (!arguments.reading.selections.empty())
    return write_page_of_bytes(stream_of_threshold(arguments), out);
  write_page_of_samples(arguments, out);
  return exit_ok;
}

std::vector<FileMesh> meshes_of_labels(const ViewArguments& arguments) {
  ExtractArguments extraction;
  extraction.volume = arguments.input;
  extraction.reading = arguments.reading;
  extraction.labels = arguments.labels;
  extraction.normals = Normals::surface;
  return label_meshes(extraction);
}

// code: receives the result of completeness().
std::vector<FileMesh> mesh_of_stream(const ViewArguments& arguments, int& code) {
  const DecodedStream decoded = decode_surface(arguments.input, {});
  code = completeness(arguments.input, decoded.report);
  const auto crossings =
      crossings_of(arguments.input, decoded, arguments.surface, arguments.tolerance);
  std::vector<FileMesh> meshes(1);
  meshes[0] =
      triangulated(decoded.surface, {true, Faces::triangles, &*crossings, arguments.tolerance});
  meshes[0].normals = surface_normals(meshes[0]);
  const auto placement = mesh_placement(arguments.input, decoded.placement, std::nullopt);
  place_in_file(meshes[0], placement, {});
  return meshes;
}

std::vector<FileMesh> meshes_of_file(const std::string& file) {
  const Progress progress("reading");
  std::vector<FileMesh> meshes = read_meshes(file);
  for (FileMesh& mesh : meshes) mesh.normals = surface_normals(mesh);
  return meshes;
}

}  // namespace

bool shows_meshes(const ViewArguments& arguments) {
  return arguments.kind == InputKind::mesh || !arguments.labels.empty() ||
         arguments.surface != SurfaceKind::merged;
}

std::string name_of(const std::string& input) {
  return input == "-" ? display_name(input) : input_name(input);
}

NamedBytes stream_of_threshold(const ViewArguments& arguments) {
  ExtractArguments extraction;
  extraction.volume = arguments.input;
  extraction.reading = arguments.reading;
  extraction.reading.selections = with_thresholds(arguments.input, arguments.reading);
  extraction.wire = Wire::slices;
  extraction.is_quiet = true;
  extraction.jobs = jobs_of(extraction);
  std::ostringstream bytes;
  write_stream(extraction, bytes);
  const std::string& threshold = extraction.reading.selections[0].name;
  return {name_of(arguments.input) + " at " + threshold + ".dmc", bytes.str(), exit_ok};
}

NamedBytes stream_in_file(const ViewArguments& arguments) {
  NamedBytes stream{name_of(arguments.input), stream_bytes(arguments.input), exit_ok};
  std::istringstream in(stream.bytes);
  stream.code = completeness(arguments.input, decode_surface(arguments.input, in, {}).report);
  return stream;
}

NamedBytes meshes_to_show(const ViewArguments& arguments, std::uint64_t max_bytes) {
  const bool is_file = arguments.labels.empty();
  int code = exit_ok;
  std::vector<FileMesh> meshes = arguments.kind == InputKind::mesh ? meshes_of_file(arguments.input)
                                 : is_file                         ? mesh_of_stream(arguments, code)
                                                                   : meshes_of_labels(arguments);
  Meshes pointers;
  for (FileMesh& mesh : meshes) {
    if (!mesh.colour) mesh.colour = PictureOptions().colour;
    pointers.push_back(&mesh);
  }
  std::ostringstream glb;
  write_glb(pointers, glb);
  NamedBytes file{name_of(arguments.input), glb.str(), code};
  if (file.bytes.size() > max_bytes)
    throw std::runtime_error(file.name + ": its meshes are " +
                             std::to_string(file.bytes.size() >> 20) +
                             " MiB, and a page holds at most " + std::to_string(max_bytes >> 20) +
                             (is_file ? "; decimate it, as by discmc extract --triangles 1000000"
                                      : "; give fewer labels, --shrink 2 or a part by --crop"));
  return file;
}

void require_size(const std::string& input, const VolumeInfo& info, std::uint64_t max_bytes) {
  const std::uint64_t bytes = info.slice_bytes() * info.dims[2];
  if (bytes > max_bytes)
    throw std::runtime_error(input + ": its samples are " + std::to_string(bytes >> 20) +
                             " MiB, and a page holds at most " + std::to_string(max_bytes >> 20) +
                             "; give --iso auto, --shrink 2 or a part by --crop");
}

int run_view(const ViewArguments& arguments) {
  if (arguments.serves) return serve_view(arguments);
  OutputFile file(arguments.output);
  const int code = write_page_of(arguments, file.stream());
  file.commit();
  if (arguments.output == "-") return code;
  print_file(arguments.output, std::cout);
  require_written(std::cout);
  if (arguments.opens && !open_in_browser(arguments.output))
    std::cerr << "discmc: no browser was found; open " << arguments.output << " in a browser\n";
  return code;
}

}  // namespace discmc::command
