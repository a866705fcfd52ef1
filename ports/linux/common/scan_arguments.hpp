// The arguments of all scanning commands, and their exit codes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "row_scan.hpp"

namespace discmc::device {

constexpr int exit_ok = 0;
constexpr int exit_failure = 1;
constexpr int exit_usage = 2;
constexpr int exit_incomplete = 3;
constexpr int exit_gone = 4;

constexpr const char* exit_codes =
    "Exit codes: 0 all rows are in the stream, 1 failed, 2 wrong usage, 3 skipped rows or an early "
    "end, 4 device removed. The stream is valid with 0, 3 and "
    "4.";

struct ScanArguments {
  ScanPlan plan;
  std::string output = "-";
  bool is_quiet = false;
};

/// Adds the options to a command; the arguments must outlive the parsing.
void add_scan_options(CLI::App& command, ScanArguments& arguments);

/// Parses, runs and reports errors. run: returns an exit code.
int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace discmc::device
