// discmc extract -o FILE.stl: a volume to meshes, one a surface.
#include <iostream>
#include <string>
#include <vector>

#include "exit_codes.hpp"
#include "extract.hpp"
#include "file_pattern.hpp"
#include "mesh_files/file_format.hpp"
#include "mesh_output.hpp"
#include "meshes/vertex_normals.hpp"
#include "output_file.hpp"
#include "progress.hpp"
#include "summary.hpp"
#include "surface/counts.hpp"
#include "volume_input.hpp"

namespace discmc::host {
namespace {

void add_normals(const ExtractArguments& arguments, const Selection& selection,
                 const Surface& surface, Mesh& mesh) {
  if (arguments.normals == Normals::none) return;
  set_polygon_normals(surface, mesh);
  if (arguments.normals == Normals::surface) return;
  const auto again =
      open_for_gradient(arguments.volume, volume_options(arguments.reading.layout), selection.low);
  add_gradient_normals(*again.reader, mesh);
}

}  // namespace

int extract_meshes(const ExtractArguments& arguments) {
  if (arguments.normals == Normals::gradient) require_second_pass(arguments.volume);
  const std::vector<NamedSelection>& selections = arguments.reading.selections;
  const FilePattern pattern(arguments.output);
  const auto volume = open_noted_volume(arguments.volume, arguments.reading);
  const VolumeInfo& info = volume->info();
  const auto placement = mesh_placement(arguments.volume, info.placement, arguments.space);
  pattern.require_folder();
  Progress progress("extracting", info.dims[2]);
  const ExtractionOptions options = extraction_options(arguments.reading, progress);

  const SurfaceReceivers receivers = receivers_for(selections);
  StreamOutput no_output(nullptr);  // the table tells what a stream would take
  for (const auto& receiver : receivers) {
    receiver->start_surface();
    if (!arguments.quiet)
      receiver->start_stream(stream_header(info, options).label(), info.placement,
                             no_output.byte_output());
  }
  const std::vector<Extraction> extractions =
      extract(*volume, options, requests_of(selections, receivers));
  note_not_numbers(arguments, extractions[0]);

  for (std::size_t i = 0; i < receivers.size(); ++i) {
    Surface& surface = receivers[i]->surface();
    surface.spacing_mm = info.spacing_mm;
    const std::string name = pattern.file_for(selections[i].name);
    OutputFile file(name);
    write_surface(
        surface, format_of(name), arguments.mesh,
        [&](Mesh& mesh) {
          note_left_out(arguments.volume, surface, mesh);
          add_normals(arguments, selections[i].selection, surface, mesh);
        },
        placement, file);
    file.commit();
    if (arguments.quiet) continue;
    if (receivers.size() > 1) std::cout << name << '\n';
    write_table(extractions[i], count(surface), receivers[i]->stream_bytes(), 0, std::cout);
  }
  if (!arguments.quiet) require_written(std::cout);
  return exit_ok;
}

}  // namespace discmc::host
