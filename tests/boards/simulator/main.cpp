// The scanner simulator: sends rows to a device, receives its stream, and checks the stream.
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>

#include "device.hpp"
#include "files/output_file.hpp"
#include "options.hpp"
#include "simulation.hpp"
#include "verdict.hpp"

namespace discmc::simulator {
namespace {

constexpr int exit_ok = 0;
constexpr int exit_failure = 1;
constexpr int exit_usage = 2;

void print_console(const Device& device) {
  std::istringstream lines(device.console());
  const char* heading = "firmware   ";
  for (std::string line; std::getline(lines, line); heading = "           ")
    std::cout << heading << line << '\n';
}

std::int64_t milliseconds(Clock::duration duration) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(duration).count();
}

void print_skipped(const Options& options, const ReceivedStream& stream) {
  std::cout << "skipped    " << stream.skipped().size() << " according to the stream, "
            << overruns(options.scanner, stream) << " of them for lack of room";
  constexpr std::size_t few = 8;
  if (!stream.skipped().empty() && stream.skipped().size() <= few) {
    std::cout << "; rows";
    for (const auto& [row, substitute] : stream.skipped()) std::cout << ' ' << row;
  }
  std::cout << '\n';
}

// A disturbance at a row beyond the end would test nothing.
void require_in_scan(const Options& options, std::uint32_t count) {
  const auto require = [count](const char* option, std::uint32_t row) {
    if (row >= count)
      throw std::invalid_argument(std::string(option) + ' ' + std::to_string(row) +
                                  ": the scan has rows 0 to " + std::to_string(count - 1));
  };
  for (const std::uint32_t row : options.scanner.dropped) require("--drop-row", row);
  for (const std::uint32_t row : options.scanner.damaged) require("--damage-row", row);
  for (const auto& pause : options.scanner.pauses) require("--pause", pause.first);
  for (const auto& stall : options.listener.stalls) require("--stall", stall.first);
  if (options.listener.hold_up) require("--hold-up", options.listener.hold_up->row);
  if (options.reset_at != ScannerBehaviour::never) require("--reset-at", options.reset_at);
}

void print_summary(const Rows& rows, const Options& options, const Simulation& simulation) {
  const Scanner& scanner = simulation.scanner();
  for (const auto& stream : simulation.received().streams()) {
    if (stream.get() == &simulation.received().stream()) break;
    std::cout << "reset      after " << stream->bytes().size() << " bytes with "
              << stream->report().regions << " regions and " << stream->final_slices()
              << " final layers\n";
  }
  const ReceivedStream& stream = simulation.received().stream();
  const StreamReport& report = stream.report();
  std::cout << "rows       " << scanner.row_count() << " of " << rows.bytes() << " bytes each; "
            << options.scanner.dropped.size() << " not sent, " << options.scanner.damaged.size()
            << " damaged\n";
  print_skipped(options, stream);
  std::cout << "regions    " << report.regions << ", of them " << simulation.early_regions()
            << " before the last row was sent\n"
            << "stream     " << stream.bytes().size() << " bytes in " << report.packets
            << " packets, " << report.lost_packets << " lost; " << report.slices << " slices"
            << (report.is_abandoned ? ", abandoned" : "") << '\n'
            << "time       " << milliseconds(simulation.duration())
            << " ms; the longest wait for the device " << milliseconds(scanner.longest_wait())
            << " ms\n";
}

void write_stream(const ReceivedStream& stream, const std::string& path) {
  command::OutputFile file(path);
  file.stream().write(reinterpret_cast<const char*>(stream.bytes().data()),
                      static_cast<std::streamsize>(stream.bytes().size()));
  file.commit();
}

int simulate(const Options& options) {
  const auto volume = command::open_volume(options.volume, {options.layout});
  const Rows rows(*volume);
  require_in_scan(options, rows.count());
  const Device device(options);
  Simulation simulation(rows, options, device.lines());
  try {
    simulation.run();
  } catch (const std::exception&) {
    print_console(device);
    throw;
  }
  const bool is_broken_off = options.scanner.broken_off_at < rows.count();
  const std::string mistake_at_end = device.mistake(is_broken_off ? 1 : 0);
  print_summary(rows, options, simulation);
  print_console(device);
  if (!options.output.empty()) write_stream(simulation.received().stream(), options.output);

  std::vector<std::string> wrong = mistakes(rows, options, simulation.received());
  if (!mistake_at_end.empty()) wrong.push_back(mistake_at_end);
  for (const std::string& mistake : wrong) std::cout << "WRONG      " << mistake << '\n';
  if (!wrong.empty()) return exit_failure;
  std::cout << "verified   equal to the extraction here, byte by byte\n";
  return exit_ok;
}

int run(int argc, char** argv) {
  CLI::App app{
      "Simulates a scanner for the firmware of examples/scanner.cpp. Sends the rows of a volume "
      "over a "
      "UART, decodes the stream from another UART, and checks every byte.",
      "scanner_simulator"};
  app.footer(
      "Rows count over all slices, from 0. Exit codes: 0 verified, 1 failed, 2 wrong usage.");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
    if (options.firmware.empty() && options.rows.empty())
      throw CLI::RequiredError("--firmware, or --rows with --stream,");
    if (options.reset_at != ScannerBehaviour::never && options.firmware.empty() &&
        options.monitor.empty())
      throw CLI::RequiredError("--monitor, which --reset-at needs,");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  return simulate(options);
}

}  // namespace
}  // namespace discmc::simulator

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // return values show that a device has closed its line
  // The folder of the sockets must be removed, so the program ends normally.
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int) { discmc::simulator::is_interrupted = 1; });
  try {
    return discmc::simulator::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "scanner_simulator: " << error.what() << '\n';
    return discmc::simulator::exit_failure;
  }
}
