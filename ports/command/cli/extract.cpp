// discmc extract: converts a volume to a stream or to meshes.
#include "extract.hpp"

#include "commands.hpp"
#include "empty_surface.hpp"
#include "jobs/processors.hpp"
#include "mesh_files/file_format.hpp"
#include "segmentation.hpp"
#include "text/message.hpp"
#include "volume_input.hpp"
#include "volumes/byte_source.hpp"

namespace discmc::command {

SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections,
                               std::optional<Kept> kept, unsigned jobs) {
  SurfaceReceivers receivers;
  for (std::size_t i = 0; i < selections.size(); ++i)
    receivers.push_back(std::make_unique<SurfaceReceiver>(kept, jobs));
  return receivers;
}

std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers) {
  std::vector<SurfaceRequest> requests;
  for (std::size_t i = 0; i < selections.size(); ++i)
    requests.push_back({selections[i].selection, make_sink(*receivers[i]), nullptr,
                        receivers[i]->builder(), receivers[i]->encoder(),
                        make_region_receiver(*receivers[i])});
  return requests;
}

unsigned jobs_of(const ExtractArguments& arguments) {
  return arguments.jobs.value_or(processors());
}

void note_not_numbers(const ExtractArguments& arguments, std::uint64_t not_numbers) {
  if (not_numbers > 0)
    print_message(arguments.volume,
                  std::to_string(not_numbers) + " samples are not a number (NaN) and count as off");
}

void check_surfaces(const ExtractArguments& arguments, const std::vector<Extraction>& extractions,
                    const MeasuredVolume& volume) {
  for (std::size_t i = 0; i < extractions.size(); ++i)
    check_surface(arguments.volume, arguments.reading, arguments.reading.selections[i], volume,
                  extractions[i]);
}

namespace {

// Whether --label names one label with smoothed walls. These walls depend on the labels beside it,
// and equal the walls that --labels makes.
bool is_smoothed_label(const ExtractArguments& arguments) {
  const VolumeArguments& reading = arguments.reading;
  if (!reading.selects_labels() || !reading.smooth_mm || !arguments.interpolates() ||
      reading.close_mm > 0 || is_read_once(arguments.volume))
    return false;
  const Segmentation segmentation(arguments.volume, reading);
  const LabelSet set = segmentation.names().together(reading.selections[0].given).set;
  return set.size() == 1 && set.begin()->second.size() == 1;
}

}  // namespace

int run_extract(const ExtractArguments& arguments) {
  if (!arguments.labels.empty()) return extract_label_meshes(arguments);
  if (is_smoothed_label(arguments)) {
    ExtractArguments alone = arguments;
    alone.labels = arguments.reading.selections[0].given;
    return extract_label_meshes(alone);
  }
  ExtractArguments found = arguments;
  found.reading.selections = with_thresholds(arguments.volume, arguments.reading);
  return format_of(found.output) == Format::stream ? extract_stream(found) : extract_meshes(found);
}

}  // namespace discmc::command
