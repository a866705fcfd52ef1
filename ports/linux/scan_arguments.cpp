#include "scan_arguments.hpp"

#include <exception>
#include <iostream>
#include <map>
#include <new>

namespace discmc::device {
namespace {

constexpr std::uint64_t generous_memory = std::uint64_t{16} << 20;

// The header's spacing is a count of nanometres in 32 bits.
constexpr double least_mm = 1e-6;
constexpr double most_mm = 2147;

CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string& text) {
        return text.find('-') == std::string::npos ? std::string() : "'" + text + "' is negative";
      },
      "");
}

std::string refusal_of(const ScanPlan& plan) {
  const auto& dims = plan.volume.dims;
  for (const std::uint32_t extent : {dims[0], dims[1]})
    if (extent < 1 || extent > Limits::max_extent)
      return "a slice is 1 to " + std::to_string(Limits::max_extent) + " voxels wide and high";
  const std::uint64_t rows = std::uint64_t{dims[1]} * dims[2];
  if (dims[2] < 1 || dims[2] > Limits::max_slices || rows > UINT32_MAX)
    return "there is at least one slice, and at most 2^30 - 1 slices and 2^32 - 1 rows";
  return "";
}

}  // namespace

void add_scan_options(CLI::App& command, ScanArguments& arguments) {
  host::VolumeInfo& volume = arguments.plan.volume;
  host::ExtractionOptions& options = arguments.plan.options;
  options.memory = generous_memory;
  command.add_option("--dims", volume.dims, "voxels of a row, rows of a slice, and slices at most")
      ->delimiter(',')
      ->required()
      ->option_text("X,Y,Z");
  command.add_option("--type", volume.type, "samples, the low byte first (default: u8)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, host::SampleType>{{"u8", host::SampleType::u8},
                                                  {"u16", host::SampleType::u16},
                                                  {"i16", host::SampleType::i16}}))
      ->option_text("u8|u16|i16");
  command.add_option("--threshold", options.threshold, "on means sample >= THRESHOLD")->required();
  command
      .add_option("--border", options.border, "of the surface, as discmc extract (default: closed)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Border>{{"closed", Border::closed}, {"open", Border::open}}))
      ->option_text("closed|open");
  command
      .add_option("--spacing", volume.spacing_mm, "between voxels, in millimetres (default: 1,1,1)")
      ->delimiter(',')
      ->check(CLI::Range(least_mm, most_mm) | CLI::Range(-most_mm, -least_mm))
      ->option_text("X,Y,Z");
  command
      .add_option("--memory", options.memory,
                  "bytes of the arena, with K or M for 1024 and 1024^2 (default: 16M)")
      ->transform(CLI::AsSizeValue(false))
      ->transform(not_negative())  // which comes before the other
      ->option_text("BYTES");
  command.add_option("-o,--output", arguments.output,
                     "the stream (.dmc); - is standard output (default)");
  command.add_flag("-q,--quiet", arguments.quiet, "no report in the end");
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
              << ": the memory of this computer is not enough: give less with --memory\n";
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
  }
  return exit_failure;
}

}  // namespace discmc::device
