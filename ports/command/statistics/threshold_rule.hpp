// Thresholds that follow from the values of a volume.
#pragma once

#include <string_view>
#include <utility>

#include "volume_statistics.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Otsu's threshold, or the threshold of a tissue in CT. Automatic is bone if values are in
/// Hounsfield units and some reach it, otherwise Otsu.
enum class ThresholdRule { automatic, otsu, bone, skin };

/// All rules with their names on the command line.
constexpr std::pair<std::string_view, ThresholdRule> threshold_rules[] = {
    {"auto", ThresholdRule::automatic},
    {"otsu", ThresholdRule::otsu},
    {"bone", ThresholdRule::bone},
    {"skin", ThresholdRule::skin}};

constexpr std::string_view name(ThresholdRule rule) {
  return threshold_rules[static_cast<std::size_t>(rule)].first;
}

/// Units: Hounsfield. Water is 0 and air -1000, so soft tissue is below bone, and air below skin.
constexpr double bone_threshold = 300;
constexpr double skin_threshold = -300;

/// Whether values are Hounsfield units: the file states this, or the values reach from air to bone.
/// Other scanners measure nothing as far below zero.
bool is_in_hounsfield(const VolumeInfo& info, const VolumeStatistics& statistics);

/// Whether some values reach the threshold and others do not.
bool divides(double threshold, const VolumeStatistics& statistics);

/// A threshold and the rule that found it, which is never automatic.
struct RuledThreshold {
  double iso;
  ThresholdRule rule;
};

/// Throws std::invalid_argument, with the range of the values, if the rule does not fit them.
RuledThreshold threshold_by(ThresholdRule rule, bool is_in_hounsfield,
                            const VolumeStatistics& statistics);

}  // namespace discmc::command
