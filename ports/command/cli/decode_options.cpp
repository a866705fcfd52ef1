// The arguments of discmc decode.
#include <memory>

#include "cli/options/input_kind.hpp"
#include "cli/options/mesh_options.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"

namespace discmc::command {
namespace {

void check(const CLI::App& decode, const StreamArguments& arguments) {
  check_surface_kind(arguments.surface, arguments.mesh, arguments.output);
  check_tolerance(arguments.surface, decode);
  check_faces(arguments.mesh.faces, arguments.output);
  check_components(arguments.components, arguments.output);
  check_space(arguments.space, arguments.output);
  check_size(arguments.size, arguments.output);
  check_normals(arguments.normals, arguments.output, false);
  if (!arguments.volume.empty() && arguments.normals != Normals::gradient)
    refuse("--volume", "is used with --normals gradient alone; add that, or leave out --volume");
}

}  // namespace

Command add_decode(CLI::App& app) {
  const auto arguments = std::make_shared<StreamArguments>();
  CLI::App* decode = app.add_subcommand("decode", "Convert a stream to a mesh, or re-encode it");
  decode->add_option("STREAM", arguments->stream, "a .dmc file; - reads standard input")
      ->required();
  add_output_option(*decode, arguments->output, "a stream on standard output")
      ->check(without_braces())
      ->required();
  add_format_option(*decode, arguments->format);
  add_choice_options(*decode, arguments->choice);
  add_normals_option(*decode, arguments->normals,
                     "from the stream, or from the samples of --volume");
  add_mesh_options(*decode, arguments->mesh);
  add_component_options(*decode, arguments->components);
  add_surface_kind_options(*decode, arguments->surface, arguments->mesh.tolerance);
  add_space_option(*decode, arguments->space);
  add_size_options(*decode, arguments->size);
  add_volume_options(*decode, arguments->options);
  CLI::Option* volume = decode->add_option("--volume", arguments->volume,
                                           "the volume that the stream was made of, for --normals "
                                           "gradient (default: the normals in the stream)");
  const auto describes_volume = [](const CLI::Option* option) {
    return option->get_group() == volume_group;
  };
  for (CLI::Option* option : decode->get_options(describes_volume))
    if (option != volume) option->needs(volume);
  decode->footer(
      "Examples:\n"
      "  discmc decode head.dmc -o head.ply\n"
      "  discmc decode head.dmc --surface relaxed -o head.stl\n"
      "  discmc decode head.dmc --normals gradient --volume head.nii.gz -o head.obj");
  decode->callback([arguments, decode] {
    add_format_to_name(arguments->format, arguments->output);
    check(*decode, *arguments);
  });
  return {decode, [arguments] { return run_decode(*arguments); }};
}

}  // namespace discmc::command
