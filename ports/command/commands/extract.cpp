// discmc extract: a volume to a stream or to meshes.
#include "extract.hpp"

#include <iostream>

#include "commands.hpp"
#include "mesh_files/file_format.hpp"

namespace discmc::host {

SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections) {
  SurfaceReceivers receivers;
  for (std::size_t i = 0; i < selections.size(); ++i)
    receivers.push_back(std::make_unique<SurfaceReceiver>());
  return receivers;
}

std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers) {
  std::vector<SurfaceRequest> requests;
  for (std::size_t i = 0; i < selections.size(); ++i)
    requests.push_back({selections[i].selection, sink_to(*receivers[i])});
  return requests;
}

void note_not_numbers(const ExtractArguments& arguments, const Extraction& extraction) {
  if (extraction.not_numbers > 0)
    std::cerr << "discmc: " << arguments.volume << ": " << extraction.not_numbers
              << " samples are not a number (NaN), and taken as off\n";
}

int run_extract(const ExtractArguments& arguments) {
  return format_of(arguments.output) == Format::stream ? extract_stream(arguments)
                                                       : extract_meshes(arguments);
}

}  // namespace discmc::host
