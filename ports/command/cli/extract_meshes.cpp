// discmc extract -o FILE.stl: converts a volume to one mesh per surface.
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"
#include "extract.hpp"
#include "extract_files.hpp"
#include "files/write_failure.hpp"
#include "mesh_output.hpp"
#include "progress.hpp"
#include "text/message.hpp"
#include "volume_input.hpp"

namespace discmc::command {

int extract_meshes(ExtractArguments arguments) {
  if (arguments.normals == Normals::gradient) require_second_pass(arguments.volume, gradient_pass);
  MeshFiles files(arguments);
  const auto volume = open_measured(arguments.volume, arguments.reading);
  const std::vector<NamedSelection>& selections = arguments.reading.selections;
  const VolumeInfo& info = volume->info();
  const auto mask = open_noted_mask(arguments.reading, info);
  files.set_placement(mesh_placement(arguments.volume, info.placement, arguments.space));
  const std::vector<std::string> names = files.names_for(selections);
  Progress progress("extracting", info.dims[2]);
  ExtractionOptions options = extraction_options(arguments.reading, progress, mask.get());
  const MendedVolume mended(arguments.reading, *volume, options);
  std::vector<NamedSelection> extracted_selections = selections;
  if (mended.is_changed()) extracted_selections[0].selection = options.selection;
  if (is_divisible(arguments)) options.jobs = jobs_of(arguments);

  const SurfaceReceivers receivers = receivers_for(selections, Kept::polygons, jobs_of(arguments));
  std::vector<SurfaceRequest> requests = requests_of(extracted_selections, receivers);
  std::vector<CrossingFinder> finders;
  if (arguments.interpolates())
    for (const NamedSelection& each : extracted_selections)
      finders.emplace_back(mended.samples().info(), each.selection, Vertex{0, 0, 0},
                           mended.deviation_mm().has_value());
  for (std::size_t i = 0; i < finders.size(); ++i) requests[i].crossings = &finders[i];
  const std::vector<Extraction> extractions = extract(mended.samples(), options, requests);
  note_not_numbers(arguments,
                   mended.is_changed() ? mended.not_numbers() : extractions[0].not_numbers);
  if (arguments.interpolates() && !mended.is_changed() && volume->has_two_values())
    print_message(arguments.volume,
                  "the volume has only two values, as a mask, so the surface keeps the steps of "
                  "the voxels; add --smooth auto");
  check_surfaces(arguments, extractions, *volume);

  std::ostream& table = table_stream(arguments.output);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    Surface& surface = receivers[i]->surface();
    surface.spacing_mm = info.spacing_mm;
    if (mended.deviation_mm() && arguments.interpolates()) {
      const Progress smoothing("smoothing");
      VolumeKeeping keeping = SmoothedVolume::keeping(
          info, *mended.deviation_mm(), arguments.mesh.tolerance, arguments.reading.border);
      keeping.jobs = jobs_of(arguments);
      keep_volumes({{&surface, &finders[i].crossings()}}, keeping);
    }
    const std::string title =
        display_name(arguments.volume) + (names.size() > 1 ? ": " + selections[i].name : "");
    std::optional<Crossings> relaxed;
    if (arguments.surface == SurfaceKind::relaxed) {
      relaxed.emplace(info.dims, surface.polygons);
      relax_noted(*relaxed, surface, arguments.reading.border, arguments.mesh.tolerance);
    }
    keep_chosen(title, arguments.components, surface);
    if (surface.polygons.empty() && !arguments.reading.allows_empty)
      throw std::runtime_error(arguments.volume +
                               ": no body is as large as --min-volume; give a smaller volume, or "
                               "accept an empty surface with --allow-empty");
    const MeshSummary mesh = files.add({surface, selections[i], names[i], title,
                                        relaxed                    ? &*relaxed
                                        : arguments.interpolates() ? &finders[i].crossings()
                                                                   : nullptr});
    if (arguments.is_quiet) continue;
    if (files.are_one())
      table << selections[i].name << '\n';
    else
      print_file(names[i], table);
    print_mesh_table(mesh, extractions[i], table);
  }
  files.finish();
  if (!arguments.is_quiet) require_written(table);
  return exit_ok;
}

}  // namespace discmc::command
