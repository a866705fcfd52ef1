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
#include "surface/counts.hpp"
#include "volume_input.hpp"
#include "volume_summary.hpp"

namespace discmc::command {
namespace {

int info_of_volume(const InfoArguments& arguments) {
  const auto volume = open_volume(arguments.input, volume_options(arguments.layout));
  const VolumeInfo& info = volume->info();
  write_volume_info(info, std::cout);
  const std::size_t notes = volume->notes().size();
  require_written(std::cout);
  Progress progress("measuring", info.dims[2]);
  const VolumeStatistics statistics =
      volume_statistics(*volume, [&progress](std::uint32_t slices) { progress.show(slices); });
  write_volume_statistics(info, statistics, std::cout);
  for (std::size_t i = notes; i < volume->notes().size(); ++i)
    std::cout << "note " << volume->notes()[i] << '\n';
  require_written(std::cout);
  return exit_ok;
}

int info_of_stream(const InfoArguments& arguments) {
  const DecodedStream decoded = decode_surface(arguments.input, arguments.choice);
  write_info(decoded.header, decoded.channel, decoded.streams, decoded.report,
             count(decoded.surface), decoded.placement, std::cout);
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
