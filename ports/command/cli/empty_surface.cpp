#include "empty_surface.hpp"

#include <cmath>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "text/value_text.hpp"

namespace discmc::command {
namespace {

std::string end_text(double value) {
  return std::isfinite(value) ? value_text(value) : std::string();
}

// As in "no voxel reaches 300".
std::string condition(const Selection& selection) {
  if (!selection.has_upper_end()) return "reaches " + value_text(selection.low);
  if (selection.is_one_value()) return "is " + value_text(selection.low);
  return "is in " + end_text(selection.low) + ".." + end_text(selection.high);
}

// As in "every voxel reaches 300".
std::string every_voxel(const VolumeArguments& arguments, const Selection& selection) {
  return (arguments.median > 0 ? "after --median every voxel " : "every voxel ") +
         condition(selection);
}

std::string reason(const VolumeArguments& arguments, const Selection& selection,
                   const ValueRange& range, bool is_full) {
  const bool has_all = selection.low <= range.least && range.greatest <= selection.high;
  if (is_full || (arguments.border == Border::open && has_all && arguments.mask.empty()))
    return every_voxel(arguments, selection) + ", and an open border has no surface";
  const bool is_reached = selection.low <= range.greatest && selection.high >= range.least;
  if (is_reached && !arguments.mask.empty())
    return "no voxel that " + condition(selection) + " is left by --mask";
  if (is_reached && arguments.median > 0)
    return "no voxel that " + condition(selection) + " is left by --median";
  return "no voxel " + condition(selection);
}

std::string name_for_people(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

// As in "the values are 0 to 255".
std::string values_text(const std::optional<ValueRange>& range) {
  if (!range) return "no value is a finite number";
  return "the values are " + value_text(range->least) + " to " + value_text(range->greatest);
}

}  // namespace

std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const Selection& selection, const MeasuredVolume& volume, bool is_full) {
  return name_for_people(path) + ": " +
         reason(arguments, selection, volume.range_with_infinities(), is_full) + ": " +
         values_text(volume.range()) + "; discmc info shows more of the values";
}

void fail_empty(const std::string& path, const VolumeArguments& arguments,
                const Selection& selection, const MeasuredVolume& volume, bool is_full) {
  throw std::runtime_error(why_empty(path, arguments, selection, volume, is_full) +
                           ", --allow-empty takes an empty surface");
}

void check_surface(const std::string& path, const VolumeArguments& arguments,
                   const Selection& selection, const MeasuredVolume& volume,
                   const Extraction& extraction) {
  const bool is_empty = extraction.statistics.facets == 0;
  if (is_empty && !arguments.allows_empty)
    fail_empty(path, arguments, selection, volume, extraction.is_full);
  if (is_empty || !extraction.is_full) return;
  std::cerr << "discmc: " << name_for_people(path) << ": " << every_voxel(arguments, selection)
            << ", so the surface is the box of the volume: " << values_text(volume.range())
            << "; discmc info shows more of the values\n";
}

}  // namespace discmc::command
