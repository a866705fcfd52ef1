// What `tune` prints.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "cycle_costs.hpp"
#include "trial.hpp"

namespace discmc::command {

/// The device and its link.
struct Device {
  double baud;
  double clock_hz;
  Core core;
  std::uint32_t sample_bytes;
};

/// With a start and a stop bit to a byte.
double seconds_on_link(const Trial& trial, const Device& device);

/// Seconds for people: three digits.
std::string seconds_text(double seconds);

/// A trial and what its row begins with.
struct TriedRow {
  std::string memory;  ///< of regions its bytes; of slices also which are key slices
  const Trial* trial;
  bool is_chosen;
};

void print_trials(const std::vector<TriedRow>& rows, Wire wire, const Device& device,
                  std::ostream& out);

const char* name(Core core);

}  // namespace discmc::command
