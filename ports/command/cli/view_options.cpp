// The arguments of discmc view.
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/options/input_kind.hpp"
#include "cli/options/mesh_options.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "files/file_pattern.hpp"
#include "pages/page.hpp"
#include "volumes/format_list.hpp"

namespace discmc::command {
namespace {

// Returns a page of the input's name in the current folder, or nothing if the input has no name.
std::string page_for(const std::string& input) {
  std::filesystem::path name = input_name(input);
  if (name.extension() == ".gz") name.replace_extension();
  const std::string stem = name.stem().string();
  const bool is_name =
      stem.find_first_of("*?[") == std::string::npos && stem != "-" && stem != "." && stem != "..";
  return is_name && !stem.empty() ? stem + ".html" : std::string();
}

void choose_output(ViewArguments& arguments) {
  if (arguments.serves || !arguments.output.empty()) return;
  arguments.output = page_for(arguments.input);
  if (arguments.output.empty())
    refuse(arguments.input, "gives the page no name; give -o PAGE.html");
  if (std::filesystem::exists(arguments.output) && !is_page(arguments.output))
    refuse(arguments.output, "exists, and is no page of discmc view; overwrite it with -o " +
                                 arguments.output + ", or choose another name");
}

// Chooses the kind by the name and the options, if they decide.
void choose_kind(const CLI::App& view, ViewArguments& arguments) {
  if (is_mesh_name(arguments.input)) {
    check_mesh_input(view, arguments.input);
    arguments.kind = InputKind::mesh;
  } else if (const std::optional<bool> is_volume = is_volume_input(view, arguments.input)) {
    check_kind(view, arguments.input, *is_volume);
    arguments.kind = *is_volume ? InputKind::volume : InputKind::stream;
  }
}

void check_surface_kind(const CLI::App& view, ViewArguments& arguments) {
  check_tolerance(arguments.surface, view);
  if (arguments.surface == SurfaceKind::merged) return;
  if (arguments.kind == InputKind::volume)
    refuse("--surface", "applies to streams; view the mesh of discmc extract --surface");
  arguments.kind = InputKind::stream;
}

// Refuses options of surfaces if the page shows samples.
void check_surface_options(const CLI::App& view, const ViewArguments& arguments) {
  if (!arguments.reading.selections.empty() || !arguments.labels.empty()) return;
  for (const CLI::Option* option : view.get_options())
    if (option->count() > 0 && option->get_group() == surface_group)
      refuse(option->get_name(), "applies to surfaces; add --iso auto or --labels all");
}

}  // namespace

Command add_view(CLI::App& app) {
  const auto arguments = std::make_shared<ViewArguments>();
  CLI::App* view = app.add_subcommand("view", "Show a volume, a stream or a mesh in the browser");
  view->add_option("INPUT", arguments->input,
                   "a volume as for extract, or a .dmc stream, where - reads standard input; or a "
                   "file of a mesh (.stl, .ply, .obj, .glb, .3mf)")
      ->required();
  view->add_option("-o,--output", arguments->output,
                   "the page to write (default: the name of the input with .html, in the current "
                   "folder, where it replaces an older page); - is standard output")
      ->check(named_with({".html", ".htm"}, "invalid name of a page"))
      ->check(without_braces());
  view->add_flag("!--no-open", arguments->opens, "do not open the browser");
  CLI::Option* serve =
      view->add_flag(
              "--serve", arguments->serves,
              "write no page; serve page and data to browsers on this computer, until Ctrl-C")
          ->excludes("--output");
  view->add_option("--port", arguments->port, "port of the server (default: any free port)")
      ->check(CLI::Range(1, 65535))
      ->needs(serve)
      ->option_text("N");
  add_volume_options(*view, arguments->reading.options);
  add_surface_options(*view, arguments->reading);
  add_label_options(*view, arguments->labels, arguments->reading,
                    "the page shows each in its colour, with its name");
  add_surface_kind_options(*view, arguments->surface, arguments->tolerance);
  view->footer(
      "The page contains its data, and needs neither network nor server. Without a threshold it "
      "holds\nthe samples, and its slider chooses any threshold. With --iso, --range or --label it "
      "holds only\nthat surface, in far fewer bytes; with --labels it holds their meshes.\n\nWith "
      "--serve, discmc serves page and data, "
      "so the page opens at once. The limit is 1 GiB of\nsamples. A stream from standard "
      "input or a named pipe is shown as it arrives. All users of\nthis computer can read the "
      "page; other computers cannot.\n\nExamples:\n  discmc view head.nii.gz\n  discmc view "
      "head.nii.gz --iso 300 -o skull.html\n  discmc view scan.dmc\n  discmc view labels.nii.gz "
      "--labels all\n  discmc view series/ "
      "--serve\n  discmc view - --serve < /dev/ttyACM0");
  view->allow_extras();
  view->callback([arguments, view] {
    add_other_files(*view, arguments->reading.options);
    choose_kind(*view, *arguments);
    if (arguments->kind != InputKind::mesh) check_surface_options(*view, *arguments);
    check_label_options(arguments->labels, arguments->reading);
    check_surface_kind(*view, *arguments);
    choose_output(*arguments);
  });
  return {view, [arguments] { return run_view(*arguments); }};
}

}  // namespace discmc::command
