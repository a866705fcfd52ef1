// The arguments of discmc compare.
#include <memory>

#include "cli/options/input_kind.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "volumes/format_list.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {
namespace {

ComparedInput input_called(const std::string& name) {
  return {name, is_stream_name(name)   ? InputKind::stream
                : is_volume_name(name) ? InputKind::volume
                                       : InputKind::mesh};
}

void check(const CompareArguments& arguments) {
  for (const ComparedInput& input : arguments.inputs)
    if (input.kind == InputKind::volume && arguments.reading.selections.empty())
      refuse(input.name, "a volume needs a threshold; give --iso auto, or a number");
}

}  // namespace

Command add_compare(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* compare = app.add_subcommand("compare", "Measure the distance between two surfaces");
  const char* const names[] = {"A", "B"};
  const char* const inputs[] = {
      "a mesh, a .dmc stream, or a volume, whose surface classic Marching Cubes makes at --iso",
      "the surface to compare with, in one of these forms"};
  for (std::size_t i = 0; i < arguments->inputs.size(); ++i)
    compare
        ->add_option_function<std::string>(
            names[i],
            [arguments, i](const std::string& name) { arguments->inputs[i] = input_called(name); },
            inputs[i])
        ->required();
  add_choice_options(*compare, arguments->choice);
  add_volume_options(*compare, arguments->reading.options);
  add_selection_options(*compare, arguments->reading.selections);
  // Marching Cubes crosses one threshold.
  for (const char* option : {"--range", "--label"})
    compare->remove_option(compare->get_option(option));
  compare->footer(
      "Prints a table from A to B and from B to A: the mean distance, the distance\n"
      "within which 99 % of the surface lie, and the largest distance. Units:\n"
      "millimetres, and voxels of B, or of A if B is a mesh.\n\n"
      "Examples:\n"
      "  discmc compare head.stl head.nii.gz --iso 300\n"
      "  discmc compare before.ply after.ply");
  compare->callback([arguments] { check(*arguments); });
  return {compare, [arguments] { return run_compare(*arguments); }};
}

}  // namespace discmc::command
