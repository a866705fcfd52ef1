// The arguments of discmc info.
#include <memory>

#include "cli/options/input_kind.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"

namespace discmc::command {

Command add_info(CLI::App& app) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* info = app.add_subcommand("info", "Print the properties of a volume or a stream");
  info->add_option("INPUT", arguments->input,
                   "a volume as for extract, or a .dmc stream; - reads standard input. Each line "
                   "has a key and its values, which docs/command.md lists. A volume has the range "
                   "and histogram of its values, and thresholds to try")
      ->required();
  add_choice_options(*info, arguments->choice);
  add_volume_options(*info, arguments->options);
  info->footer(
      "Examples:\n"
      "  discmc info head.dmc\n"
      "  discmc info head.nii.gz");
  info->allow_extras();
  info->callback([arguments, info] {
    add_other_files(*info, arguments->options);
    arguments->is_volume = is_volume_input(*info, arguments->input);
    if (arguments->is_volume) check_kind(*info, arguments->input, *arguments->is_volume);
  });
  return {info, [arguments] { return run_info(*arguments); }};
}

}  // namespace discmc::command
