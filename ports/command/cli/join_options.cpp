// The arguments of discmc join.
#include <memory>

#include "cli/options/option_checks.hpp"
#include "command_line.hpp"
#include "commands.hpp"

namespace discmc::command {

Command add_join(CLI::App& app) {
  const auto arguments = std::make_shared<JoinArguments>();
  CLI::App* join = app.add_subcommand("join", "Join the streams of slabs to that of the volume");
  join->add_option("STREAM", arguments->streams,
                   "the .dmc files of slabs, made by discmc extract --slab or joined before, in "
                   "any order")
      ->required();
  join->add_option("-o,--output", arguments->output, "the stream to write; - is standard output")
      ->check(named_with({".dmc"}, "what is joined is a stream"))
      ->check(without_braces())
      ->required();
  add_memory_option(*join, arguments->memory,
                    "bytes for pieces that wait for others, with K, M or G for 1024, 1024^2 and "
                    "1024^3 (default: 1G); more go to a temporary file in the folder TMPDIR");
  join->add_flag("-q,--quiet", arguments->quiet, "print nothing of what was written");
  join->footer(
      "Examples:\n"
      "  for k in 1 2 3 4; do discmc extract v.nrrd --iso 300 --slab $k/4 -o part$k.dmc & done; "
      "wait\n"
      "  discmc join part?.dmc -o v.dmc");
  return {join, [arguments] { return run_join(*arguments); }};
}

}  // namespace discmc::command
