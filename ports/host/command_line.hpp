// The arguments of the discmc command, and how they are told and checked.
#ifndef DISCMC_HOST_COMMAND_LINE_HPP
#define DISCMC_HOST_COMMAND_LINE_HPP

#include <CLI/CLI.hpp>
#include <cstdint>
#include <discmc/limits.hpp>
#include <optional>
#include <string>
#include <vector>

#include "volume.hpp"

namespace discmc::host {

/// Of `extract`.
struct ExtractArguments {
  std::string volume;
  std::string output = "-";
  double iso = 0;
  Border border = Border::closed;
  std::uint64_t memory = 0;
  std::vector<std::uint32_t> dims;
  std::optional<SampleType> type;
  bool big_endian = false;
  std::vector<double> spacing;
  bool conforming = true;
  bool quiet = false;
};

/// Of `decode`, `info` and `render`; each uses what it needs.
struct StreamArguments {
  std::string stream;
  std::string output;
  bool conforming = true;
  std::vector<double> view = {-0.9, -1.6, 0.8};
  std::vector<int> size = {1024, 1024};
  bool outlines = false;
};

/// Adds `extract` to a command line that fills the arguments, which must outlive the parsing.
void add_extract(CLI::App& app, ExtractArguments& arguments);

/// Adds `decode`, `info` and `render` likewise.
void add_stream_commands(CLI::App& app, StreamArguments& arguments);

}  // namespace discmc::host

#endif
