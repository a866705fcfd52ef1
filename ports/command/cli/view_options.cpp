// The arguments of discmc view.
#include <filesystem>
#include <memory>

#include "cli/options/input_kind.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/surface_options.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "files/input_name.hpp"

namespace discmc::command {
namespace {

// A page of the same name in the folder where the user is; nothing where the input has no name.
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
    throw CLI::ValidationError(arguments.input, "gives the page no name: give -o PAGE.html");
  if (std::filesystem::exists(arguments.output))
    throw CLI::ValidationError(arguments.output,
                               "is there already: give -o " + arguments.output + " to replace it");
}

// Samples as they are have no surface.
void check_surface_options(const CLI::App& view, const ViewArguments& arguments) {
  if (!arguments.reading.selections.empty()) return;
  for (const CLI::Option* option : view.get_options())
    if (option->count() > 0 && option->get_group() == surface_group)
      throw CLI::ValidationError(option->get_name(),
                                 "is of the surface at one threshold: give --iso auto as well");
}

}  // namespace

Command add_view(CLI::App& app) {
  const auto arguments = std::make_shared<ViewArguments>();
  CLI::App* view = app.add_subcommand(
      "view", "Write a page that shows a volume or a stream, and open it in the browser");
  view->add_option("INPUT", arguments->input,
                   "a volume as extract takes it, or a .dmc stream; - reads standard input")
      ->required();
  view->add_option("-o,--output", arguments->output,
                   "the page to write (default: the input's name with .html, in this folder); - is "
                   "standard output")
      ->check(named_with({".html", ".htm"}, "pages are HTML files"))
      ->check(without_braces());
  view->add_flag("!--no-open", arguments->opens, "leave the browser alone");
  CLI::Option* serve = view->add_flag("--serve", arguments->serves,
                                      "write no page: serve it with the data beside it, for "
                                      "browsers on this computer, until Ctrl-C")
                           ->excludes("--output");
  view->add_option("--port", arguments->port, "of the server (default: any that is free)")
      ->check(CLI::Range(1, 65535))
      ->needs(serve)
      ->option_text("N");
  add_volume_options(*view, arguments->reading.options);
  add_surface_options(*view, arguments->reading);
  view->footer(
      "The page holds all that it shows, and needs neither network nor server. Without a "
      "threshold\n"
      "it has the samples, and any threshold can be chosen in it; with --iso, --range or --label "
      "it\n"
      "has that surface alone, in a small part of the bytes.\n"
      "\n"
      "With --serve nothing is put into the page, so it opens at once, and takes up to 1 GiB of\n"
      "samples. A stream from standard input or a named pipe is shown while it comes. Every "
      "program\n"
      "of this computer can ask for the page, and no other computer.\n"
      "\n"
      "Examples:\n"
      "  discmc view head.nii.gz\n"
      "  discmc view head.nii.gz --iso 300 -o skull.html\n"
      "  discmc view scan.dmc\n"
      "  discmc view series/ --serve\n"
      "  discmc view - --serve < /dev/ttyACM0");
  view->callback([arguments, view] {
    arguments->is_volume = is_volume_input(*view, arguments->input);
    if (arguments->is_volume) check_kind(*view, arguments->input, *arguments->is_volume);
    check_surface_options(*view, *arguments);
    choose_output(*arguments);
  });
  return {view, [arguments] { return run_view(*arguments); }};
}

}  // namespace discmc::command
