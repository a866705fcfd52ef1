// The options of the command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "listener.hpp"
#include "scanner.hpp"
#include "volumes/volume.hpp"

namespace CLI {
class App;
}

namespace discmc::simulator {

struct Options {
  std::string volume;
  std::optional<command::RawLayout> layout;
  std::uint64_t memory = 0;

  std::string firmware;
  std::string rows;
  std::string stream;
  std::string monitor;

  ScannerBehaviour scanner;
  std::uint32_t reset_at = ScannerBehaviour::never;
  ListenerBehaviour listener;

  std::string output;
};

void add_options(CLI::App& app, Options& options);

}  // namespace discmc::simulator
