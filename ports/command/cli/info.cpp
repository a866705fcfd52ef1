// discmc info: what is in a stream or a volume.
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "exit_codes.hpp"
#include "input_content.hpp"
#include "progress.hpp"
#include "require.hpp"
#include "statistics/volume_statistics.hpp"
#include "stream_input.hpp"
#include "summary.hpp"
#include "volume_input.hpp"
#include "volume_summary.hpp"

namespace discmc::command {
namespace {

int info_of_volume(const InfoArguments& arguments) {
  const auto volume = open_layer(arguments.input, volume_options(arguments.layout));
  VolumeInfo info = volume->info();
  if (info.frames > 1 && !arguments.layout.frame)
    note(info, "the values are those of layer 0; --frame N tells those of another");
  print_volume_info(info, std::cout);
  const std::size_t notes = volume->notes().size();
  require_written(std::cout);
  Progress progress("measuring", info.dims[2]);
  const VolumeStatistics statistics =
      volume_statistics(*volume, [&progress](std::uint32_t slices) { progress.show(slices); });
  print_volume_statistics(info, statistics, std::cout);
  for (std::size_t i = notes; i < volume->notes().size(); ++i)
    std::cout << "note " << volume->notes()[i] << '\n';
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
