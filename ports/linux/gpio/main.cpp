// discmc-gpio: a scan whose rows are triggered by a GPIO line.
#include <discmc/version.h>
#include <chrono>
#include <iostream>
#include <memory>

#include "cli/progress.hpp"
#include "common/device_gone.hpp"
#include "common/scan_arguments.hpp"
#include "common/stop_signal.hpp"
#include "common/stream_target.hpp"
#include "line_events.hpp"
#include "triggered_scan.hpp"

namespace discmc::device {
namespace {

// The delay with which a signal is noticed that arrives just before waiting begins.
constexpr std::chrono::milliseconds patience{100};

struct Arguments {
  Wiring wiring;
  std::string rows;
  bool simulate = false;
  ScanArguments scan;
};

void add_options(CLI::App& app, Arguments& arguments) {
  Wiring& wiring = arguments.wiring;
  app.add_option("--chip", wiring.chip, "the GPIO chip, by name (gpiochip0), path or label")
      ->required();
  app.add_option("--sync", wiring.sync, "the line with an edge per row, by offset or name")
      ->required()
      ->option_text("LINE");
  app.add_flag("--falling", wiring.sync_is_falling, "count falling edges (default: rising)");
  app.add_option("--button", wiring.button,
                 "a button that starts, pauses and continues the scan; held for a second, the "
                 "button ends it")
      ->option_text("LINE");
  app.add_option("--end-stop", wiring.end_stop, "a line that ends the scan")->option_text("LINE");
  app.add_flag("--to-ground", wiring.contacts_to_ground,
               "button and end-stop connect to ground, with a pull-up (default: active is high)");
  CLI::Option* rows = app.add_option("--rows", arguments.rows,
                                     "read samples from a device or pipe that gives a row per "
                                     "edge, from a file of rows, or from standard input (-)");
  app.add_flag("--simulate", arguments.simulate, "generate samples")->excludes(rows);
  add_scan_options(app, arguments.scan);
}

std::unique_ptr<RowSource> row_source(const Arguments& arguments) {
  const ScanPlan& plan = arguments.scan.plan;
  if (arguments.simulate) return simulated_rows(plan.dims, plan.type);
  if (arguments.rows.empty()) throw CLI::RequiredError("--rows or --simulate");
  return open_rows(arguments.rows);
}

void follow(LineEvents& lines, TriggeredScan& triggered, const RowScan& scan,
            StreamTarget& target) {
  command::Progress progress("row", 0);
  bool is_printed = false;
  while (triggered.state() != TriggeredScan::State::ended && !stop_signal::came()) {
    for (const LineEvent& event : lines.wait(patience)) triggered.process(event);
    target.flush();
    progress.show(scan.rows());
    if (is_printed || !triggered.first_missed_row()) continue;
    is_printed = true;  // once, because printing takes time; the report counts them all
    std::cerr << "discmc-gpio: edges were missed from row " << *triggered.first_missed_row()
              << " on, so their rows are skipped; slow the stage down\n";
  }
}

int run(const Arguments& arguments) {
  const ScanArguments& planned = arguments.scan;
  stop_signal::watch();
  const auto source = row_source(arguments);
  LineEvents lines(arguments.wiring);
  StreamTarget target(planned.output);
  RowScan scan(planned.plan, target.output());
  TriggeredScan triggered(scan, *source, planned.plan.row_bytes(),
                          !arguments.wiring.button.empty());
  if (!planned.is_quiet) std::cerr << "discmc-gpio: ready\n";
  bool is_gone = false;
  try {
    follow(lines, triggered, scan, target);
    scan.finish();
  } catch (const DeviceGone& gone) {
    std::cerr << "discmc-gpio: " << gone.what() << "; the stream ends after " << scan.rows()
              << " of " << planned.plan.rows() << " rows; it is valid and marked as incomplete\n";
    is_gone = true;
    scan.abandon();
  }
  target.flush();
  if (!planned.is_quiet) {
    triggered.report(std::cerr);
    scan.report(std::cerr);
  }
  if (is_gone) return exit_gone;
  return scan.is_whole() ? exit_ok : exit_incomplete;
}

}  // namespace
}  // namespace discmc::device

int main(int argc, char** argv) {
  using namespace discmc::device;
  CLI::App app{"Write the surface of a scan as a stream; a GPIO line triggers its rows",
               "discmc-gpio"};
  app.set_version_flag("--version", discmc::version());
  app.footer(exit_codes);
  Arguments arguments;
  add_options(app, arguments);
  return run_command(app, argc, argv, [&] { return run(arguments); });
}
