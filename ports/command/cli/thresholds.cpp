
#include <algorithm>
#include <stdexcept>

#include "progress.hpp"
#include "statistics/volume_statistics.hpp"
#include "text/message.hpp"
#include "text/number_text.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

bool has_rule(const NamedSelection& surface) {
  return surface.rule.has_value();
}

bool needs_values(const NamedSelection& surface) {
  return surface.rule == ThresholdRule::otsu || surface.rule == ThresholdRule::automatic;
}

RuledThreshold found(const std::string& path, const NamedSelection& surface, bool is_in_hounsfield,
                     const VolumeStatistics& statistics) {
  try {
    return threshold_by(*surface.rule, is_in_hounsfield, statistics);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(display_name(path) + ": " + error.what());
  }
}

}  // namespace

std::vector<NamedSelection> with_thresholds(const std::string& path,
                                            const VolumeArguments& arguments) {
  std::vector<NamedSelection> surfaces = arguments.selections;
  const auto first = std::find_if(surfaces.begin(), surfaces.end(), has_rule);
  if (first == surfaces.end()) return surfaces;
  require_second_pass(path, "--iso " + first->name + " reads the volume twice");

  const auto volume = open_noted(path, arguments.options);
  const VolumeInfo& info = volume->info();
  VolumeStatistics statistics;
  if (!info.is_in_hounsfield || std::any_of(surfaces.begin(), surfaces.end(), needs_values)) {
    Progress progress("measuring", info.dims[2]);
    statistics =
        volume_statistics(*volume, [&progress](std::uint32_t slices) { progress.show(slices); });
  }
  for (NamedSelection& surface : surfaces) {
    if (!has_rule(surface)) continue;
    const RuledThreshold threshold =
        found(path, surface, is_in_hounsfield(info, statistics), statistics);
    surface.selection = {threshold.iso};
    std::string text = "--iso " + surface.name + ": " + value_text(threshold.iso);
    if (threshold.rule != surface.rule) text += " (" + std::string(name(threshold.rule)) + ')';
    const auto padding = padding_value(statistics);
    if (threshold.rule == ThresholdRule::otsu && padding)
      text += ", without the " + value_text(*padding) + " outside the scanned circle";
    print_message(path, text);
  }
  return surfaces;
}

}  // namespace discmc::command
