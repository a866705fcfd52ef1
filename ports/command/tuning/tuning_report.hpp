// The output of `tune`.
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

/// Counts a start and a stop bit per byte.
double seconds_on_link(const Trial& trial, const Device& device);

/// Formats seconds for people, in three digits.
std::string seconds_text(double seconds);

/// A trial and the beginning of its row in the table.
struct TriedRow {
  std::string memory;  ///< bytes for regions; for slices also the key-slice interval
  const Trial* trial;
  bool is_chosen;
};

void print_trials(const std::vector<TriedRow>& rows, Wire wire, const Device& device,
                  std::ostream& out);

const char* name(Core core);

}  // namespace discmc::command
