// discmc info: what is in a stream or a volume.
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "exit_codes.hpp"
#include "progress.hpp"
#include "replayed_input.hpp"
#include "require.hpp"
#include "statistics/volume_statistics.hpp"
#include "stream_input.hpp"
#include "summary.hpp"
#include "surface/counts.hpp"
#include "volume_input.hpp"
#include "volume_summary.hpp"

namespace discmc::host {
namespace {

std::string head_of(std::istream& in) {
  std::string head(magic_bytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

// What cannot be opened may be a pattern of names; else the volume's reader says what is wrong.
bool begins_like_volume(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return !file || is_volume_head(head_of(file));
}

int info_of_volume(const InfoArguments& arguments) {
  const auto volume = open_volume(arguments.input, volume_options(arguments.layout));
  const VolumeInfo& info = volume->info();
  write_volume_info(info, std::cout);
  require_written(std::cout);
  Progress progress("measuring", info.dims[2]);
  const VolumeStatistics statistics =
      volume_statistics(*volume, [&progress](std::uint32_t slices) { progress.show(slices); });
  write_volume_statistics(info, statistics, std::cout);
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
  bool is_volume = false;
  if (arguments.is_volume) {
    is_volume = *arguments.is_volume;
  } else if (arguments.input == "-") {
    const std::string head = head_of(std::cin);
    is_volume = is_volume_head(head);
    replayed.emplace(head);
  } else if (!is_read_once(arguments.input)) {
    is_volume = begins_like_volume(arguments.input);
  }
  return is_volume ? info_of_volume(arguments) : info_of_stream(arguments);
}

}  // namespace discmc::host
