// The command line: the commands, and the parsing and checks of their arguments.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace discmc::command {

struct Command {
  CLI::App* app;             ///< Owner: the command line
  std::function<int()> run;  ///< runs with the parsed arguments; returns the exit code
};

// Each adds one command and is in the file named after it. The last two, which describe all
// commands, are in documents.cpp.

Command add_extract(CLI::App& app);
Command add_decode(CLI::App& app);
Command add_join(CLI::App& app);
Command add_info(CLI::App& app);
Command add_render(CLI::App& app);
Command add_view(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_tune(CLI::App& app);
Command add_completions(CLI::App& app);
Command add_manual(CLI::App& app);

}  // namespace discmc::command
