#include "stack.hpp"

#include <array>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

#include "volumes/declared_place.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

using Spacing = std::array<std::optional<double>, 3>;

bool is_given(const Spacing& spacing) {
  return spacing[0] || spacing[1] || spacing[2];
}

std::string note_of_resolution(const Resolution& resolution) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const bool has_unit = resolution.unit_mm > 0;
  const double unit = has_unit ? resolution.unit_mm : resolution.pixels[0];
  text << "the resolution, " << (has_unit ? "usually for a print" : "which has no unit")
       << ", is not used; to use it, give --spacing " << unit / resolution.pixels[0] << ','
       << unit / resolution.pixels[1] << ",Z";
  return text.str();
}

// Returns the spacing in SkyScan's log, if the log describes these slices.
Spacing spacing_of_log(const Stack& stack, VolumeInfo& info) {
  const auto log = skyscan_log(stack.files[0]);
  if (!log) return {};
  const std::string called = shown(log->file.filename().string());
  const std::array<std::uint32_t, 2> size = {stack.header.width, stack.header.height};
  const bool is_of_slices = log->size == std::array<std::uint32_t, 2>{} || log->size == size;
  note(info, is_of_slices ? "spacing from " + called
                          : called + " describes slices of another size, and is not used");
  if (!is_of_slices) return {};
  return {log->spacing_mm[0], log->spacing_mm[1], log->spacing_mm[2]};
}

Spacing spacing_of(const Stack& stack, VolumeInfo& info) {
  Spacing spacing = stack.described.spacing_mm;
  if (!is_given(spacing)) spacing = spacing_of_log(stack, info);
  const auto& resolution = stack.header.resolution;
  if (!is_given(spacing) && resolution &&
      (resolution->unit_mm > 0 || resolution->pixels[0] != resolution->pixels[1]))
    note(info, note_of_resolution(*resolution));
  // Assumes square pixels and cubic voxels.
  if (!spacing[1]) spacing[1] = spacing[0];
  if (spacing[0] && !spacing[2]) {
    spacing[2] = spacing[0];
    if (stack.pages.size() > 1)
      note(info, "no distance of slices given, the distance of pixels is used");
  }
  return spacing;
}

}  // namespace

void set_place_of(VolumeInfo& info, const Stack& stack, const VolumeOptions& options) {
  DeclaredPlace place;
  place.set_unit("mm");
  if (!options.spacing_mm) place.spacing = spacing_of(stack, info);
  place.directions = coordinates;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double step =
        options.spacing_mm ? (*options.spacing_mm)[axis] : place.spacing[axis].value_or(1);
    if (axis < 2 && stack.header.runs_backwards[axis]) {
      (*place.directions)[axis][axis] = -1;
      step = -step;
      note(info, axis == 0 ? "the first column is the right one (Orientation)"
                           : "the first row is the lowest (Orientation)");
    }
    place.origin[axis] = -stack.described.origin_voxel[axis] * step;
  }
  set_place(info, place, options);
}

}  // namespace discmc::command
