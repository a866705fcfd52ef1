#include "volume_input.hpp"

#include <algorithm>
#include <iostream>

namespace discmc::host {

std::optional<RawLayout> raw_layout(const LayoutArguments& arguments) {
  if (arguments.dims.empty()) return std::nullopt;
  RawLayout layout;
  std::copy_n(arguments.dims.begin(), 3, layout.dims.begin());
  layout.type = *arguments.type;
  layout.big_endian = arguments.big_endian;
  if (!arguments.spacing.empty())
    std::copy_n(arguments.spacing.begin(), 3, layout.spacing_mm.begin());
  return layout;
}

std::unique_ptr<VolumeReader> open_noted_volume(const std::string& path,
                                                const VolumeArguments& arguments) {
  auto volume = open_volume(path, raw_layout(arguments.layout));
  for (const std::string& note : volume->info().notes)
    std::cerr << "discmc: " << path << ": " << note << '\n';
  return volume;
}

ExtractionOptions extraction_options(const VolumeInfo& info, const VolumeArguments& arguments,
                                     Progress& progress) {
  ExtractionOptions options;
  options.threshold = stored_threshold(info, arguments.isos[0]);
  options.border = arguments.border;
  options.memory = arguments.memory;
  if (!arguments.capacities.empty())
    options.capacities = Capacities{arguments.capacities[0], arguments.capacities[1]};
  options.progress = [&progress](std::uint32_t slices) { progress.show(slices); };
  return options;
}

}  // namespace discmc::host
