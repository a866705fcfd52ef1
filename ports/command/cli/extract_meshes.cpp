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
namespace {

// Returns a finder per surface, or none if vertices stay halfway between voxels.
std::vector<CrossingFinder> finders_for(const ExtractArguments& arguments,
                                        const std::vector<NamedSelection>& selections,
                                        const MendedVolume& mended) {
  std::vector<CrossingFinder> finders;
  if (!arguments.interpolates()) return finders;
  for (const NamedSelection& each : selections)
    finders.emplace_back(mended.samples().info(), each.selection, Vertex{0, 0, 0},
                         mended.deviation_mm().has_value());
  return finders;
}

void note_two_values(const ExtractArguments& arguments, const MeasuredVolume& volume) {
  if (volume.has_two_values())
    print_message(arguments.volume,
                  "the volume has only two values, as a mask, so the surface keeps the steps of "
                  "the voxels; add --smooth auto");
}

// Smoothing shrinks bodies, and this enlarges them again.
void keep_smoothed_volumes(const ExtractArguments& arguments, const VolumeInfo& info,
                           double deviation_mm, Surface& surface, Crossings& crossings) {
  const Progress smoothing("smoothing");
  VolumeKeeping keeping = SmoothedVolume::keeping(info, deviation_mm, arguments.mesh.tolerance,
                                                  arguments.reading.border);
  keeping.jobs = jobs_of(arguments);
  keep_volumes({{&surface, &crossings}}, keeping);
}

std::optional<Crossings> relaxed_if_requested(const ExtractArguments& arguments,
                                              const VolumeInfo& info, const Surface& surface) {
  if (arguments.surface != SurfaceKind::relaxed) return std::nullopt;
  std::optional<Crossings> relaxed(std::in_place, info.dims, surface.polygons);
  relax_noted(*relaxed, surface, arguments.reading.border, arguments.mesh.tolerance);
  return relaxed;
}

void keep_chosen_bodies(const ExtractArguments& arguments, const std::string& title,
                        Surface& surface) {
  keep_chosen(title, arguments.components, surface);
  if (surface.polygons.empty() && !arguments.reading.allows_empty)
    throw std::runtime_error(arguments.volume +
                             ": no body is as large as --min-volume; give a smaller volume, or "
                             "accept an empty surface with --allow-empty");
}

}  // namespace

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
  std::vector<CrossingFinder> finders = finders_for(arguments, extracted_selections, mended);
  for (std::size_t i = 0; i < finders.size(); ++i) requests[i].crossings = &finders[i];
  const std::vector<Extraction> extractions = extract(mended.samples(), options, requests);
  note_not_numbers(arguments,
                   mended.is_changed() ? mended.not_numbers() : extractions[0].not_numbers);
  if (arguments.interpolates() && !mended.is_changed()) note_two_values(arguments, *volume);
  check_surfaces(arguments, extractions, *volume);

  std::ostream& table = table_stream(arguments.output);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    Surface& surface = receivers[i]->surface();
    surface.spacing_mm = info.spacing_mm;
    Crossings* positions = finders.empty() ? nullptr : &finders[i].crossings();
    if (positions != nullptr && mended.deviation_mm())
      keep_smoothed_volumes(arguments, info, *mended.deviation_mm(), surface, *positions);
    std::optional<Crossings> relaxed = relaxed_if_requested(arguments, info, surface);
    if (relaxed) positions = &*relaxed;
    const std::string title =
        display_name(arguments.volume) + (names.size() > 1 ? ": " + selections[i].name : "");
    keep_chosen_bodies(arguments, title, surface);
    const MeshSummary mesh = files.add({surface, selections[i], names[i], title, positions});
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
