// discmc info: what is in a stream.
#include <iostream>
#include <string>

#include "commands.hpp"
#include "require.hpp"
#include "stream_input.hpp"
#include "summary.hpp"
#include "surface/counts.hpp"

namespace discmc::host {

int run_info(const StreamArguments& arguments) {
  const DecodedStream decoded = decode_surface(arguments.stream, arguments.choice);
  write_info(decoded.header, decoded.channel, decoded.streams, decoded.report,
             count(decoded.surface), decoded.placement, std::cout);
  for (const std::string& record : decoded.records) std::cout << "record " << record << '\n';
  require_written(std::cout);
  return completeness(arguments.stream, decoded.report);
}

}  // namespace discmc::host
