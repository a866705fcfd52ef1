#include "empty_surface.hpp"

#include <cmath>
#include <iostream>
#include <optional>

#include "statistics/value_text.hpp"

namespace discmc::host {
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

std::string reason(const VolumeArguments& arguments, const Selection& selection,
                   const std::optional<ValueRange>& range) {
  const bool is_reached =
      range && selection.low <= range->greatest && selection.high >= range->least;
  if (is_reached && !arguments.mask.empty())
    return "no voxel that " + condition(selection) + " is left by --mask";
  if (is_reached && arguments.median > 0)
    return "no voxel that " + condition(selection) + " is left by --median";
  if (arguments.border == Border::open && range && selection.low <= range->least &&
      range->greatest <= selection.high)
    return "every voxel " + condition(selection) + ", and an open border has no surface";
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
                      const Selection& selection, const MeasuredVolume& volume) {
  const auto range = volume.range();
  return name_for_people(path) + ": " + reason(arguments, selection, range) + ": " +
         values_text(range) + "; discmc info shows more of the values";
}

void fail_empty(const std::string& path, const VolumeArguments& arguments,
                const Selection& selection, const MeasuredVolume& volume) {
  throw VolumeError(why_empty(path, arguments, selection, volume) +
                    ", --allow-empty takes an empty surface");
}

void note_full(const std::string& path, const Selection& selection, const MeasuredVolume& volume) {
  std::cerr << "discmc: " << name_for_people(path) << ": every voxel " << condition(selection)
            << ", so the surface is the box of the volume: " << values_text(volume.range())
            << "; discmc info shows more of the values\n";
}

}  // namespace discmc::host
