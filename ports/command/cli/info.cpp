// discmc info: the properties of a volume or a stream.
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "files/write_failure.hpp"
#include "input_content.hpp"
#include "progress.hpp"
#include "statistics/volume_statistics.hpp"
#include "stream_input.hpp"
#include "summary.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

// printed: the number of notes already printed.
void print_notes(const std::vector<std::string>& notes, std::size_t& printed) {
  for (; printed < notes.size(); ++printed) std::cout << "note " << notes[printed] << '\n';
}

int info_of_volume(const InfoArguments& arguments) {
  const auto volume = open_layer(arguments.input, arguments.options);
  const VolumeInfo& info = volume->info();
  print_volume_info(info, std::cout);
  std::size_t printed = 0;
  print_notes(volume->notes(), printed);
  if (info.frames > 1 && !arguments.options.frame)
    std::cout << "note the values are those of layer 0; choose another with --frame N\n";
  require_written(std::cout);
  Progress progress("measuring", info.dims[2]);
  const VolumeStatistics statistics =
      volume_statistics(*volume, [&progress](std::uint32_t slices) { progress.show(slices); });
  print_volume_statistics(info, statistics, std::cout);
  print_notes(volume->notes(), printed);
  require_written(std::cout);
  return exit_ok;
}

int info_of_stream(const InfoArguments& arguments) {
  const DecodedStream decoded = decode_surface(arguments.input, arguments.choice, Kept::counts);
  print_info(decoded.header, decoded.channel, decoded.streams, decoded.report, decoded.counts,
             decoded.placement, std::cout);
  for (const std::string& record : decoded.records) std::cout << "record " << record << '\n';
  require_written(std::cout);
  return completeness(arguments.input, decoded.report);
}

}  // namespace

int run_info(const InfoArguments& arguments) {
  std::optional<ReplayedInput> replayed;
  const bool is_volume =
      arguments.is_volume ? *arguments.is_volume : begins_like_volume(arguments.input, replayed);
  return is_volume ? info_of_volume(arguments) : info_of_stream(arguments);
}

}  // namespace discmc::command
