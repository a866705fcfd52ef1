#include "length_unit.hpp"

#include <utility>

#include "volume_format.hpp"

namespace discmc::command {

std::optional<double> millimetres_in(std::string_view unit) {
  constexpr std::pair<std::string_view, double> units[] = {
      {"mm", 1},         {"millimeter", 1}, {"cm", 10},       {"m", 1000},       {"um", 1e-3},
      {"\u00b5m", 1e-3}, {"\u03bcm", 1e-3}, {"micron", 1e-3}, {"microns", 1e-3}, {"nm", 1e-6},
      {"inch", 25.4},    {"in", 25.4},      {"meter", 1000}};
  for (const auto& [name, mm] : units)
    if (unit == name) return mm;
  return std::nullopt;
}

}  // namespace discmc::command
