#include "scan_arguments.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <vector>

#include "cli/options/option_checks.hpp"

namespace discmc::device {
namespace {

std::string refusal_of(const ScanPlan& plan) {
  const auto& dims = plan.dims;
  for (const std::uint32_t extent : {dims[0], dims[1]})
    if (extent < 1 || extent > Limits::max_extent)
      return std::to_string(extent) + ": invalid size of a slice; expected 1 to " +
             std::to_string(Limits::max_extent) + " voxels along x and y";
  const std::uint64_t rows = std::uint64_t{dims[1]} * dims[2];
  if (dims[2] < 1 || dims[2] > Limits::max_slices || rows > UINT32_MAX)
    return std::to_string(dims[2]) +
           ": invalid number of slices; expected 1 to 2^30 - 1 slices, and up to 2^32 - 1 rows";
  return "";
}

}  // namespace

void add_scan_options(CLI::App& command, ScanArguments& arguments) {
  ScanPlan& plan = arguments.plan;
  command
      .add_option_function<std::vector<std::uint32_t>>(
          "--dims",
          [&plan](const std::vector<std::uint32_t>& extents) {
            std::copy_n(extents.begin(), 3, plan.dims.begin());
          },
          "voxels per row, rows per slice, and most slices")
      ->delimiter(',')
      ->expected(3)
      ->required()
      ->option_text("X,Y,Z");
  command.add_option("--type", plan.type, "sample type, with the low byte first (default: u8)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, meshing::SampleType>{{"u8", meshing::SampleType::u8},
                                                     {"u16", meshing::SampleType::u16},
                                                     {"i16", meshing::SampleType::i16}}))
      ->option_text("u8|u16|i16");
  command.add_option("--threshold", plan.threshold, "a voxel is on if its sample is >= THRESHOLD")
      ->required();
  command
      .add_option("--border", plan.border,
                  "closed: voxels outside the volume are off; open: the surface ends at the "
                  "outermost voxels (default: closed)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Border>{{"closed", Border::closed}, {"open", Border::open}}))
      ->option_text("closed|open");
  command
      .add_option_function<std::vector<double>>(
          "--spacing",
          [&plan](const std::vector<double>& spacing) {
            std::copy_n(spacing.begin(), 3, plan.spacing_mm.begin());
          },
          "distances between voxels in millimetres (default: 1,1,1)")
      ->delimiter(',')
      ->expected(3)
      ->check(command::usable_spacing())
      ->option_text("X,Y,Z");
  command::add_memory_option(command, plan.memory,
                             "bytes of the arena, with K or M for 1024 and 1024^2 (default: 16M)");
  command.add_option("-o,--output", arguments.output,
                     "the stream to write (.dmc); - is standard output (default)");
  command.add_flag("-q,--quiet", arguments.is_quiet, "do not print the report");
  command.callback([&arguments] {
    const std::string refusal = refusal_of(arguments.plan);
    if (!refusal.empty()) throw CLI::ValidationError("--dims", refusal);
  });
}

int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  } catch (const std::bad_alloc&) {
    std::cerr << app.get_name()
              << ": the memory of this computer is not enough; give less with --memory\n";
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
  }
  return exit_failure;
}

}  // namespace discmc::device
