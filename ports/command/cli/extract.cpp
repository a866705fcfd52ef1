// discmc extract: a volume to a stream or to meshes.
#include "extract.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <thread>
#include <utility>

#include "commands.hpp"
#include "empty_surface.hpp"
#include "extraction/labels.hpp"
#include "mesh_files/file_format.hpp"
#include "text/control_character.hpp"
#include "thresholds.hpp"

namespace discmc::command {

SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections,
                               std::optional<Kept> kept) {
  SurfaceReceivers receivers;
  for (std::size_t i = 0; i < selections.size(); ++i)
    receivers.push_back(std::make_unique<SurfaceReceiver>(kept));
  return receivers;
}

std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers) {
  std::vector<SurfaceRequest> requests;
  for (std::size_t i = 0; i < selections.size(); ++i)
    requests.push_back({selections[i].selection, make_sink(*receivers[i]), nullptr,
                        receivers[i]->builder(), receivers[i]->encoder()});
  return requests;
}

LabelTable label_table_of(const ExtractArguments& arguments) {
  return arguments.label_table.empty() ? LabelTable{} : read_label_table(arguments.label_table);
}

void describe(NamedSelection& selection, const LabelTable& table) {
  const Selection& values = selection.selection;
  if (!values.is_one_value() || std::fabs(values.low) >= end_of_labels) return;
  const auto found = table.find(static_cast<std::int64_t>(values.low));
  if (found == table.end()) return;
  selection.name = without_control(found->second.name);
  selection.colour = found->second.colour;
}

unsigned jobs_of(const ExtractArguments& arguments) {
  return arguments.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
}

void note_not_numbers(const ExtractArguments& arguments, std::uint64_t not_numbers) {
  if (not_numbers > 0)
    std::cerr << "discmc: " << arguments.volume << ": " << not_numbers
              << " samples are not a number (NaN), and taken as off\n";
}

void check_surfaces(const ExtractArguments& arguments, const std::vector<Extraction>& extractions,
                    const MeasuredVolume& volume) {
  for (std::size_t i = 0; i < extractions.size(); ++i)
    check_surface(arguments.volume, arguments.reading, arguments.reading.selections[i].selection,
                  volume, extractions[i]);
}

int run_extract(const ExtractArguments& arguments) {
  if (arguments.takes_all_labels) return extract_label_meshes(arguments);
  ExtractArguments found = arguments;
  found.reading.selections = with_thresholds(arguments.volume, arguments.reading);
  const LabelTable table = label_table_of(arguments);
  for (NamedSelection& each : found.reading.selections) describe(each, table);
  return format_of(found.output) == Format::stream ? extract_stream(found) : extract_meshes(found);
}

}  // namespace discmc::command
