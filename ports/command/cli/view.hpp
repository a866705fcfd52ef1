// What discmc view does, by where the page has its data.
#ifndef DISCMC_COMMAND_CLI_VIEW_HPP
#define DISCMC_COMMAND_CLI_VIEW_HPP

#include <cstdint>
#include <string>

#include "arguments.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Serves the page with the data beside it, until the user ends it. Returns the exit code.
int serve_view(const ViewArguments& arguments);

/// The name of the input, for people.
std::string name_of(const std::string& input);

/// A stream in memory. code: as of completeness().
struct NamedStream {
  std::string name;
  std::string bytes;
  int code;
};

/// The surface at the threshold that is asked for, as slices.
NamedStream stream_of_threshold(const ViewArguments& arguments);
/// A file that is a stream already.
NamedStream stream_in_file(const ViewArguments& arguments);

/// Throws std::runtime_error where the volume has more bytes of samples than a page holds.
void require_size(const std::string& input, const VolumeInfo& info, std::uint64_t most);

}  // namespace discmc::command

#endif
