// The discmc command.
#include <discmc/version.h>
#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "cli/help/outline.hpp"
#include "cli/help/usage_error.hpp"
#include "command_line.hpp"
#include "commands.hpp"

namespace discmc::command {
namespace {

// `discmc help extract` is `discmc extract --help`. CLI11 expects the words in reverse.
std::vector<std::string> reversed_words(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  std::reverse(words.begin(), words.end());
  return words;
}

int run(int argc, char** argv) {
  CLI::App app{"Extract surfaces of scanned volumes by Discretized Marching Cubes", "discmc"};
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "print this help");
  app.set_version_flag("--version", discmc::version(), "print the version");
  app.formatter_fn([](const CLI::App* command, const std::string&, CLI::AppFormatMode) {
    return help(outline_of(*command));
  });
  app.failure_message(usage_error);
  const std::vector<Command> commands = {
      add_extract(app), add_view(app), add_info(app), add_render(app),      add_compare(app),
      add_decode(app),  add_join(app), add_tune(app), add_completions(app), add_manual(app)};
  app.footer(
      "Examples:\n"
      "  discmc view head.nii.gz\n"
      "  discmc extract head.nii.gz --iso auto -o head.stl\n\n"
      "Exit codes: 0 done, 1 failed, 2 wrong usage, 3 done but the stream was incomplete.");
  try {
    app.parse(reversed_words(argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  return std::find_if(commands.begin(), commands.end(),
                      [](const Command& command) { return command.app->parsed(); })
      ->run();
}

}  // namespace
}  // namespace discmc::command

int main(int argc, char** argv) {
  // A file beyond the size limit becomes a failed write, which is reported.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return discmc::command::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "discmc: the memory of this computer is not enough; extract a part with --crop, "
                 "or --shrink\n";
    return discmc::command::exit_failure;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "discmc: " << error.path1().string() << ": " << error.code().message()
              << "; check the name and the permissions\n";
    return discmc::command::exit_failure;
  } catch (const std::exception& error) {
    std::cerr << "discmc: " << error.what() << '\n';
    return discmc::command::exit_failure;
  }
}
