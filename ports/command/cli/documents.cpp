// discmc completions and discmc manual: the command line as documents.
#include <iostream>
#include <memory>

#include "cli/help/outline.hpp"
#include "cli/options/named_values.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "files/write_failure.hpp"

namespace discmc::command {
namespace {

using Completions = std::string (*)(const CommandOutline&);

int write(const std::string& document) {
  std::cout << document;
  require_written(std::cout);
  return exit_ok;
}

}  // namespace

Command add_completions(CLI::App& app) {
  const auto completions = std::make_shared<Completions>(nullptr);
  CLI::App* command =
      app.add_subcommand("completions", "Write command-line completions for a shell");
  add_named_option(
      *command, "SHELL", *completions,
      NamedValues<Completions>{
          {"bash", bash_completions}, {"zsh", zsh_completions}, {"fish", fish_completions}},
      "bash, zsh or fish")
      ->required();
  command->footer(
      "Examples:\n"
      "  source <(discmc completions bash)\n"
      "  discmc completions fish > ~/.config/fish/completions/discmc.fish");
  return {command, [completions, &app] { return write((*completions)(outline_of(app))); }};
}

Command add_manual(CLI::App& app) {
  CLI::App* command = app.add_subcommand("manual", "Write the manual page, in troff");
  command->footer(
      "Examples:\n"
      "  discmc manual | man -l -");
  return {command, [&app] { return write(manual(outline_of(app), app.version())); }};
}

}  // namespace discmc::command
