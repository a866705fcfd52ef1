#include "empty_surface.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "text/message.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

std::string end_text(double value) {
  return std::isfinite(value) ? value_text(value) : std::string();
}

// Example: "no voxel reaches 300".
std::string condition(const NamedSelection& surface) {
  const Selection& selection = surface.selection;
  if (surface.is_label) return "has label " + surface.name;
  if (!selection.has_upper_end()) return "reaches " + value_text(selection.low);
  return "is in " + end_text(selection.low) + ".." + end_text(selection.high);
}

// Example: "every voxel reaches 300".
std::string every_voxel(const VolumeArguments& arguments, const NamedSelection& surface) {
  return (arguments.median > 0 ? "after --median every voxel " : "every voxel ") +
         condition(surface);
}

std::string reason(const VolumeArguments& arguments, const NamedSelection& surface,
                   const MeasuredVolume& volume, bool is_full) {
  const Selection& selection = surface.selection;
  const ValueRange range = volume.range_with_infinities();
  const bool has_all =
      !surface.is_label && selection.low <= range.least && range.greatest <= selection.high;
  if (is_full || (arguments.border == Border::open && has_all && arguments.mask.empty()))
    return every_voxel(arguments, surface) + ", so a surface with --border open is empty";
  // A sample of labels holds bits of several labels, so the range of samples does not answer this.
  const bool is_reached =
      surface.is_label || (selection.low <= range.greatest && selection.high >= range.least);
  const std::string end = surface.is_label ? ", or no voxel has that label" : "";
  if (is_reached && !arguments.mask.empty())
    return "no voxel that " + condition(surface) + " is left by --mask" + end;
  if (is_reached && arguments.smooth_mm)
    return "no voxel that " + condition(surface) + " is left by --smooth" + end;
  if (is_reached && arguments.median > 0)
    return "no voxel that " + condition(surface) + " is left by --median" + end;
  return "no voxel " + condition(surface);
}

// Example: "the values are 0 to 255".
std::string values_text(const std::optional<ValueRange>& range) {
  if (!range) return "no value is finite";
  return "the values are " + value_text(range->least) + " to " + value_text(range->greatest);
}

// Example: ", the values are 0 to 255; choose a threshold with discmc info".
std::string value_hint(const NamedSelection& surface, const MeasuredVolume& volume) {
  if (surface.is_label) return "; list the labels with discmc info";
  return ", and " + values_text(volume.range()) + "; choose a threshold with discmc info";
}

}  // namespace

std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const NamedSelection& surface, const MeasuredVolume& volume, bool is_full) {
  return display_name(path) + ": " + reason(arguments, surface, volume, is_full) +
         value_hint(surface, volume);
}

void fail_empty(const std::string& path, const VolumeArguments& arguments,
                const NamedSelection& surface, const MeasuredVolume& volume, bool is_full) {
  throw std::runtime_error(why_empty(path, arguments, surface, volume, is_full) +
                           ", or accept an empty surface with --allow-empty");
}

void check_surface(const std::string& path, const VolumeArguments& arguments,
                   const NamedSelection& surface, const MeasuredVolume& volume,
                   const Extraction& extraction) {
  const bool is_empty = extraction.statistics.facets == 0;
  if (is_empty && !arguments.allows_empty)
    fail_empty(path, arguments, surface, volume, extraction.is_full);
  if (is_empty || !extraction.is_full) return;
  print_message(path, every_voxel(arguments, surface) +
                          ", so the surface is the box of the volume" +
                          value_hint(surface, volume));
}

}  // namespace discmc::command
