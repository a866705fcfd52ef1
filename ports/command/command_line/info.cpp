// The arguments of discmc info.
#include <memory>

#include "command_line.hpp"
#include "commands/commands.hpp"
#include "stream_options.hpp"

namespace discmc::host {

Command add_info(CLI::App& app) {
  const auto arguments = std::make_shared<StreamArguments>();
  CLI::App* info = app.add_subcommand("info", "Tell what a stream holds, one key and value a line");
  info->add_option("STREAM", arguments->stream, "a .dmc file; - reads standard input")->required();
  add_choice_options(*info, arguments->choice);
  info->footer(
      "Examples:\n"
      "  discmc info head.dmc");
  return {info, [arguments] { return run_info(*arguments); }};
}

}  // namespace discmc::host
