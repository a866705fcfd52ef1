#include "threshold_rule.hpp"

#include <stdexcept>
#include <string>

#include "text/value_text.hpp"

namespace discmc::command {
namespace {

std::string range_text(const VolumeStatistics& statistics) {
  return value_text(statistics.least) + " to " + value_text(statistics.greatest);
}

RuledThreshold otsu(const VolumeStatistics& statistics) {
  if (const auto iso = otsu_threshold(statistics)) return {*iso, ThresholdRule::otsu};
  throw std::invalid_argument(statistics.numbers == 0
                                  ? "no value is finite, so there is no threshold; check the file"
                                  : "all values are " + value_text(statistics.least) +
                                        ", so no threshold divides them; give --iso " +
                                        value_text(statistics.least) + " to select them all");
}

}  // namespace

bool is_in_hounsfield(const VolumeInfo& info, const VolumeStatistics& statistics) {
  constexpr double air_at_most = -500;
  constexpr double beyond = 65536;  // no scanner writes a larger magnitude
  return info.is_in_hounsfield ||
         (statistics.least <= air_at_most && statistics.greatest >= bone_threshold &&
          statistics.least > -beyond && statistics.greatest < beyond);
}

bool divides(double threshold, const VolumeStatistics& statistics) {
  return statistics.least < threshold && threshold <= statistics.greatest;
}

RuledThreshold threshold_by(ThresholdRule rule, bool is_in_hounsfield,
                            const VolumeStatistics& statistics) {
  if (rule == ThresholdRule::automatic)
    rule = is_in_hounsfield && divides(bone_threshold, statistics) ? ThresholdRule::bone
                                                                   : ThresholdRule::otsu;
  if (rule == ThresholdRule::otsu) return otsu(statistics);
  if (!is_in_hounsfield)
    throw std::invalid_argument("--iso " + std::string(name(rule)) +
                                " needs Hounsfield units, and the values are " +
                                range_text(statistics) + "; give a number or --iso otsu");
  return {rule == ThresholdRule::bone ? bone_threshold : skin_threshold, rule};
}

}  // namespace discmc::command
