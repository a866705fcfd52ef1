// discmc-hid: a scan with rows from HID reports.
#include <discmc/version.h>
#include <chrono>
#include <iostream>

#include "cli/progress.hpp"
#include "common/device_gone.hpp"
#include "common/scan_arguments.hpp"
#include "common/stop_signal.hpp"
#include "common/stream_target.hpp"
#include "hid_device.hpp"
#include "row_assembler.hpp"
#include "stream_reports.hpp"

namespace discmc::device {
namespace {

// The delay with which a signal is noticed that arrives just before waiting begins.
constexpr std::chrono::milliseconds patience{100};

struct Arguments {
  std::string device;
  bool echo = false;
  ScanArguments scan;
};

CLI::App* add_scan(CLI::App& app, Arguments& arguments) {
  CLI::App* scan = app.add_subcommand("scan", "Scan, and write the surface as a stream");
  scan->add_option("DEVICE", arguments.device,
                   "the device: a path, or vendor:product as in discmc-hid list")
      ->required();
  scan->add_flag("--echo", arguments.echo, "also send the stream to the device");
  add_scan_options(*scan, arguments.scan);
  return scan;
}

int run_list() {
  if (list_hid_devices(std::cout) == 0)
    std::cerr << "discmc-hid: no HID device found; connect the scanner\n";
  return exit_ok;
}

// Passes the stream to the file and, on request, to the device.
struct Output {
  StreamTarget target;
  StreamReports reports;
  ByteOutput file;
  bool echo;

  Output(const std::string& path, bool echoes)
      : target(path), file(target.output()), echo(echoes) {}

  ByteOutput byte_output() {
    return {this, [](void* context, const std::uint8_t* bytes, std::size_t count) {
              auto& self = *static_cast<Output*>(context);
              if (self.echo) self.reports.put(bytes, count);
              return self.file.write(self.file.context, bytes, count);
            }};
  }
};

void send(HidDevice& device, Report::Kind kind) {
  HidDevice::Bytes report;
  Report{kind, 0, 0, 0, nullptr}.write(report.data());
  device.write(report);
}

// Receives reports until the scan has all its rows, or the scanner or the user ends it.
void follow(HidDevice& device, RowAssembler& assembler, RowScan& scan, Output& output) {
  command::Progress progress("row", 0);
  HidDevice::Bytes report{};
  bool has_ended = false;
  while (!has_ended && !scan.has_all_rows() && !stop_signal::came()) {
    const std::size_t count = device.read(report, patience);
    if (count == 0) continue;
    const RowAssembler::Received received = assembler.add(report.data(), count);
    scan.skip(received.lost_rows);
    if (received.has_row) scan.push(assembler.row());
    has_ended = received.has_ended;
    output.target.flush();
    output.reports.send_full([&](const auto& bytes) { device.write(bytes); });
    progress.show(scan.rows());
  }
}

// Whether the device still exists after an operation with it.
template <class Step>
bool outlives(Step step) {
  try {
    step();
    return true;
  } catch (const DeviceGone& gone) {
    std::cerr << "discmc-hid: " << gone.what() << '\n';
    return false;
  }
}

int run_scan(const Arguments& arguments) {
  const ScanArguments& planned = arguments.scan;
  stop_signal::watch();
  HidDevice device(arguments.device);
  Output output(planned.output, arguments.echo);
  RowScan scan(planned.plan, output.byte_output());
  RowAssembler assembler(planned.plan.row_bytes(), planned.plan.rows());

  const bool is_scanned = outlives([&] {
    send(device, Report::Kind::start);
    follow(device, assembler, scan, output);
  });
  if (is_scanned) {
    scan.finish();
  } else {
    scan.abandon();
    std::cerr << "discmc-hid: the stream ends after " << scan.rows() << " of "
              << planned.plan.rows() << " rows; it is valid and marked as incomplete\n";
  }
  output.target.flush();
  const bool is_confirmed =
      is_scanned && outlives([&] {
        if (arguments.echo)
          output.reports.send_all([&](const auto& bytes) { device.write(bytes); });
        send(device, Report::Kind::stop);
      });

  if (!planned.is_quiet) {
    assembler.report(std::cerr);
    scan.report(std::cerr);
  }
  if (!is_scanned || (arguments.echo && !is_confirmed)) return exit_gone;
  return scan.is_whole() ? exit_ok : exit_incomplete;
}

}  // namespace
}  // namespace discmc::device

int main(int argc, char** argv) {
  using namespace discmc::device;
  CLI::App app{"Write the surface of a scan as a stream; HID reports contain its rows",
               "discmc-hid"};
  app.set_version_flag("--version", discmc::version());
  app.require_subcommand(1);
  app.footer(exit_codes);
  Arguments arguments;
  app.add_subcommand("list", "List the HID devices: path, vendor:product, names");
  const CLI::App* scan = add_scan(app, arguments);
  return run_command(app, argc, argv,
                     [&] { return scan->parsed() ? run_scan(arguments) : run_list(); });
}
