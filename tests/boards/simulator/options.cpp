#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/options/option_checks.hpp"

namespace discmc::simulator {
namespace {

using std::chrono::milliseconds;

void add_volume(CLI::App& app, Options& options) {
  const auto layout = [&options]() -> command::RawLayout& {
    if (!options.layout) options.layout.emplace();
    return *options.layout;
  };
  app.add_option("VOLUME", options.volume,
                 "what is scanned: a volume as discmc extract takes it, or headerless samples with "
                 "--dims and --type")
      ->required();
  CLI::Option* dims = app.add_option_function<std::vector<std::uint32_t>>(
                             "--dims",
                             [layout](const std::vector<std::uint32_t>& extents) {
                               std::copy_n(extents.begin(), 3, layout().dims.begin());
                             },
                             "extents of a headerless file, in voxels")
                          ->delimiter(',')
                          ->expected(3)
                          ->option_text("X,Y,Z");
  CLI::Option* type = app.add_option_function<std::string>(
                             "--type",
                             [layout](const std::string& name) {
                               layout().type = *meshing::sample_type_called(name);
                             },
                             "samples of a headerless file")
                          ->check(CLI::IsMember({"u8", "u16", "i16"}))
                          ->option_text("u8|u16|i16");
  dims->needs(type);
  type->needs(dims);
  command::add_memory_option(app, options.memory,
                             "the arena_bytes of the firmware's scan.hpp; K for 1024 (required)")
      ->required();
}

void add_device(CLI::App& app, Options& options) {
  const char* group = "Device";
  CLI::Option* firmware = app.add_option("--firmware", options.firmware,
                                         "runs this program in QEMU, on the board mps2_an386")
                              ->option_text("FILE")
                              ->group(group);
  CLI::Option* rows =
      app.add_option("--rows", options.rows,
                     "the line for rows: a Unix socket to listen at, or a serial port (which stty "
                     "has made raw)")
          ->option_text("PATH")
          ->excludes(firmware)
          ->group(group);
  CLI::Option* stream = app.add_option("--stream", options.stream, "the line of the stream, alike")
                            ->option_text("PATH")
                            ->excludes(firmware)
                            ->group(group);
  app.add_option("--monitor", options.monitor, "QEMU's monitor, alike, for --reset-at")
      ->option_text("PATH")
      ->excludes(firmware)
      ->needs(rows)
      ->group(group);
  rows->needs(stream);
  stream->needs(rows);
}

// Options that may be repeated, with one value each.

void add_times(CLI::App& app, const char* name, std::map<std::uint32_t, milliseconds>& times,
               const char* description, const char* group) {
  app.add_option_function<std::vector<std::uint32_t>>(
         name,
         [&times, name](const std::vector<std::uint32_t>& given) {
           if (given.size() % 2 != 0)
             throw CLI::ValidationError(name, "needs pairs of a row and milliseconds: ROW,MS");
           for (std::size_t i = 0; i < given.size(); i += 2)
             times[given[i]] = milliseconds(given[i + 1]);
         },
         description)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("ROW,MS")
      ->group(group);
}

void add_rows(CLI::App& app, const char* name, std::set<std::uint32_t>& rows,
              const char* description) {
  app.add_option_function<std::vector<std::uint32_t>>(
         name,
         [&rows](const std::vector<std::uint32_t>& given) {
           rows.insert(given.begin(), given.end());
         },
         description)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("ROW,...")
      ->group("Scanner");
}

void add_microseconds(CLI::App& app, const char* name, std::chrono::microseconds& time,
                      const char* description) {
  app.add_option_function<std::int64_t>(
         name, [&time](std::int64_t given) { time = std::chrono::microseconds(given); },
         description)
      ->check(CLI::Range(0, 1000000000))
      ->option_text("US")
      ->group("Scanner");
}

void add_scanner(CLI::App& app, Options& options) {
  ScannerBehaviour& scanner = options.scanner;
  add_microseconds(app, "--pace", scanner.pace, "from row to row, at least; microseconds");
  add_microseconds(app, "--jitter", scanner.jitter, "of the pace, either way; microseconds");
  add_times(app, "--pause", scanner.pauses, "waits this long before these rows", "Scanner");
  add_rows(app, "--drop-row", scanner.dropped, "rows that are not sent");
  add_rows(app, "--damage-row", scanner.damaged, "rows that are sent with a wrong byte");
  app.add_option("--break-off-at", scanner.broken_off_at, "ends the scan before this row")
      ->option_text("ROW")
      ->group("Scanner");
  app.add_flag_function(
         "--no-credit", [&scanner](std::int64_t) { scanner.waits_for_credit = false; },
         "never waits for the device: what it has no room for is lost")
      ->group("Scanner");
  app.add_option("--reset-at", options.reset_at,
                 "resets the device, once, when the scan is at this row")
      ->option_text("ROW")
      ->group("Scanner");
}

void add_receiver(CLI::App& app, Options& options) {
  app.add_option("--slow", options.listener.bytes_per_second, "reads this many bytes per second")
      ->check(CLI::Range(1, 1000000000))
      ->option_text("BYTES")
      ->group("Receiver");
  add_times(app, "--stall", options.listener.stalls,
            "stops reading for this long when the scan is at these rows", "Receiver");
  // Otherwise the scanner would wait for the device, and the device for the receiver.
  app.add_option_function<std::vector<std::uint32_t>>(
         "--hold-up",
         [&options](const std::vector<std::uint32_t>& given) {
           options.listener.hold_up = HoldUp{given[0], given[1]};
         },
         "stops reading when the scan is at this row, until the device has dropped this many "
         "frames")
      ->delimiter(',')
      ->expected(2)
      ->needs("--no-credit")
      ->option_text("ROW,FRAMES")
      ->group("Receiver");
  app.add_option("-o,--output", options.output, "the stream of the last scan, as a .dmc file")
      ->option_text("FILE")
      ->group("Receiver");
}

}  // namespace

void add_options(CLI::App& app, Options& options) {
  add_volume(app, options);
  add_device(app, options);
  add_scanner(app, options);
  add_receiver(app, options);
}

}  // namespace discmc::simulator
