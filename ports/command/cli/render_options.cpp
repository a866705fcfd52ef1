// The arguments of discmc render.
#include <memory>

#include "cli/options/input_kind.hpp"
#include "cli/options/mesh_options.hpp"
#include "cli/options/named_values.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "volumes/format_list.hpp"

namespace discmc::command {
namespace {

void check_surface(const CLI::App& render, const RenderArguments& arguments) {
  check_tolerance(arguments.surface, render);
  if (arguments.surface == SurfaceKind::merged) return;
  if (!arguments.labels.empty()) refuse("--surface", "labels are drawn merged; leave it out");
  if (arguments.surface == SurfaceKind::interpolated && arguments.reading.median > 0)
    refuse("--median",
           "cannot be combined with --surface interpolated, as the samples are not filtered; leave "
           "one out");
}

void check(const CLI::App& render, const RenderArguments& arguments) {
  const bool is_volume = arguments.kind == InputKind::volume;
  if (arguments.kind == InputKind::mesh)
    check_mesh_input(render, arguments.input);
  else
    check_kind(render, arguments.input, is_volume);
  if (is_volume && arguments.reading.selections.empty() && arguments.labels.empty())
    refuse(arguments.input, "a volume needs a threshold; give --iso auto, or a number");
  check_label_options(arguments.labels, arguments.reading);
  if (arguments.view == std::vector<double>{0, 0, 0})
    refuse("--view", "0,0,0 is not a direction; give another vector");
  check_closed(arguments.components, arguments.reading.border);
  check_surface(render, arguments);
}

void add_picture_options(CLI::App& app, RenderArguments& arguments) {
  app.option_defaults()->group("Picture");
  app.add_option("--view", arguments.view, "direction from the surface to the viewer")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->option_text("X,Y,Z")
      ->capture_default_str();
  app.add_option("--size", arguments.size, "width and height in pixels")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1, 8192))
      ->option_text("W,H")
      ->capture_default_str();
  app.add_option("--zoom", arguments.zoom, "enlarge the picture; at 1 all of the surface is in it")
      ->check(finite())
      ->check(CLI::Range(1e-3, 1e3))
      ->option_text("FACTOR")
      ->capture_default_str();
  app.add_option("--at", arguments.at,
                 "point in the middle of the picture, in millimetres as with --space voxel "
                 "(default: the middle of the surface)")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->option_text("X,Y,Z");
  add_named_option(app, "--shade", arguments.smooth,
                   NamedValues<bool>{{"flat", false}, {"smooth", true}},
                   "flat: every face in one colour; smooth: by the normals of vertices");
  app.add_flag("--edges", arguments.draws_outlines, "draw the outlines of the merged polygons");
}

void add_classic_option(CLI::App& app, bool& classic) {
  app.option_defaults()->group(surface_group);
  app.add_flag("--classic", classic, "draw the triangles of classic Marching Cubes, to compare")
      ->excludes("--memory")
      ->excludes("--capacities")
      ->excludes("--median")
      ->excludes("--mask")
      ->excludes("--largest")
      ->excludes("--min-volume")
      ->excludes("--fill")
      ->excludes("--surface")
      ->excludes("--range")
      ->excludes("--label")
      ->excludes("--labels");
}

}  // namespace

Command add_render(CLI::App& app) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* render =
      app.add_subcommand("render", "Draw a volume, a stream or a mesh as a PNG picture");
  render
      ->add_option("INPUT", arguments->input,
                   "a .dmc stream or a volume as for extract, where - reads standard input; or a "
                   "file of a mesh (.stl, .ply, .obj, .glb, .3mf)")
      ->required();
  render
      ->add_option("-o,--output", arguments->output, "the PNG file to write; - is standard output")
      ->check(named_with({".png", ".PNG"}, "invalid name of a picture"))
      ->check(without_braces())
      ->required();
  add_picture_options(*render, *arguments);
  add_choice_options(*render, arguments->choice);
  add_volume_options(*render, arguments->reading.options);
  add_surface_options(*render, arguments->reading);
  add_label_options(*render, arguments->labels, arguments->reading, "each has its colour");
  add_component_options(*render, arguments->components);
  add_surface_kind_options(*render, arguments->surface, arguments->tolerance);
  add_classic_option(*render, arguments->classic);
  render->footer(
      "Examples:\n"
      "  discmc render head.dmc --edges -o head.png\n"
      "  discmc render head.nii.gz --iso 300 --shade smooth -o head.png\n"
      "  discmc render labels.nii.gz --labels all -o labels.png");
  render->callback([arguments, render] {
    arguments->kind = is_mesh_name(arguments->input) ? InputKind::mesh
                      : is_volume_input(*render, arguments->input).value_or(false)
                          ? InputKind::volume
                          : InputKind::stream;
    check(*render, *arguments);
  });
  return {render, [arguments] { return run_render(*arguments); }};
}

}  // namespace discmc::command
