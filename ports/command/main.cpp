// The discmc command.
#include <exception>
#include <iostream>
#include <new>

#include "command_line.hpp"
#include "commands/commands.hpp"
#include "commands/exit_codes.hpp"

namespace discmc::host {
namespace {

int run(int argc, char** argv) {
  CLI::App app{
      "Surfaces of scanned volumes by Discretized Marching Cubes, merged while they stream",
      "discmc"};
  app.require_subcommand(1);
  app.set_version_flag("--version", DISCMC_VERSION);
  app.footer("Exit codes: 0 done, 1 failed, 2 wrong usage, 3 done but the stream was incomplete.");
  ExtractArguments extract_arguments;
  StreamArguments stream_arguments;
  RenderArguments render_arguments;
  add_extract(app, extract_arguments);
  add_stream_commands(app, stream_arguments);
  add_render(app, render_arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  if (app.got_subcommand("extract")) return run_extract(extract_arguments);
  if (app.got_subcommand("decode")) return run_decode(stream_arguments);
  if (app.got_subcommand("info")) return run_info(stream_arguments);
  return run_render(render_arguments);
}

}  // namespace
}  // namespace discmc::host

int main(int argc, char** argv) {
  try {
    return discmc::host::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr
        << "discmc: the memory of this computer is not enough: take a smaller volume or stream\n";
    return discmc::host::exit_failure;
  } catch (const std::exception& error) {
    std::cerr << "discmc: " << error.what() << '\n';
    return discmc::host::exit_failure;
  }
}
