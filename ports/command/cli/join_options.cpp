// The arguments of discmc join.
#include <memory>

#include "cli/options/option_checks.hpp"
#include "command_line.hpp"
#include "commands.hpp"

namespace discmc::command {

Command add_join(CLI::App& app) {
  const auto arguments = std::make_shared<JoinArguments>();
  CLI::App* join =
      app.add_subcommand("join", "Join the streams of slabs to the stream of the volume");
  join->add_option(
          "STREAM", arguments->streams,
          "the .dmc files of slabs in any order, from discmc extract --slab or discmc join")
      ->required();
  join->add_option("-o,--output", arguments->output,
                   "the stream to write, a .dmc file; - is standard output")
      ->check(named_with({".dmc"}, "invalid name of a stream"))
      ->check(without_braces())
      ->required();
  add_memory_option(*join, arguments->memory,
                    "bytes for waiting fragments, with K, M or G for 1024, 1024^2 and 1024^3 "
                    "(default: 1G). The rest goes to a temporary file in the folder TMPDIR");
  join->add_flag("-q,--quiet", arguments->is_quiet, "do not print the table of results");
  join->footer(
      "Examples:\n"
      "  for k in 1 2 3 4; do discmc extract v.nrrd --iso 300 --slab $k/4 -o part$k.dmc & done; "
      "wait\n"
      "  discmc join part?.dmc -o v.dmc");
  return {join, [arguments] { return run_join(*arguments); }};
}

}  // namespace discmc::command
