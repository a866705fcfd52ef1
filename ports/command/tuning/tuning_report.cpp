#include "tuning_report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "text/number_text.hpp"

namespace discmc::command {
namespace {

constexpr double bits_per_byte = 10;  // 8N1

double seconds(const DeviceWork& work, Wire wire, const Device& device) {
  return cycles_of(work, device.sample_bytes, cycle_costs(device.core, wire)) / device.clock_hz;
}

// Returns the rate in the slowest slice.
double rows_per_second_at_worst(const Trial& trial, Wire wire, const Device& device) {
  double longest = 0;
  DeviceWork before;
  for (const DeviceWork& total : trial.slices) {
    longest = std::max(longest, seconds(total - before, wire, device));
    before = total;
  }
  return static_cast<double>(trial.slices.front().rows) / longest;
}

std::string rows_text(double rows_per_second) {
  // Rounds to the digits that the estimate supports.
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(rows_per_second)) - 1));
  return grouped(static_cast<std::uint64_t>(std::round(rows_per_second / unit) * unit));
}

}  // namespace

double seconds_on_link(const Trial& trial, const Device& device) {
  return static_cast<double>(trial.stream_bytes()) * bits_per_byte / device.baud;
}

std::string seconds_text(double seconds) {
  const int digits = seconds >= 100 ? 0 : seconds >= 10 ? 1 : seconds >= 1 ? 2 : 3;
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << seconds;
  return text.str();
}

void print_trials(const std::vector<TriedRow>& rows, Wire wire, const Device& device,
                  std::ostream& out) {
  const bool is_of_regions = wire == Wire::regions;
  const int memory_width = is_of_regions ? 11 : 28;
  const auto loose = [&](const std::string& text) {
    if (is_of_regions) out << std::setw(13) << text;
  };
  out << "  " << std::right << std::setw(memory_width) << (is_of_regions ? "arena" : "memory");
  loose("fragments");
  out << std::setw(13) << "stream" << std::setw(10) << "link" << std::setw(10) << "CPU"
      << std::setw(9) << "rows/s" << std::setw(10) << "at worst" << '\n';
  for (const TriedRow& row : rows) {
    const Trial& trial = *row.trial;
    const double work = seconds(trial.work, wire, device);
    const double scan = std::max(work, seconds_on_link(trial, device));
    out << (row.is_chosen ? "> " : "  ") << std::setw(memory_width) << row.memory;
    loose(grouped(trial.loose_pieces));
    out << std::setw(13) << grouped(trial.stream_bytes()) << std::setw(8)
        << seconds_text(seconds_on_link(trial, device)) << " s" << std::setw(8)
        << seconds_text(work) << " s" << std::setw(9)
        << rows_text(static_cast<double>(trial.work.rows) / scan) << std::setw(10)
        << rows_text(rows_per_second_at_worst(trial, wire, device)) << '\n';
  }
}

const char* name(Core core) {
  constexpr const char* names[] = {"Cortex-M0+", "Cortex-M4", "Cortex-M7"};
  return names[static_cast<std::size_t>(core)];
}

}  // namespace discmc::command
