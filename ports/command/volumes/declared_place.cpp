#include "declared_place.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

using Vector = std::array<double, 3>;

std::string list(const Vector& numbers) {
  return '(' + short_number(numbers[0]) + ", " + short_number(numbers[1]) + ", " +
         short_number(numbers[2]) + ')';
}

double length(const Vector& vector) {
  return std::hypot(vector[0], vector[1], vector[2]);
}

Vector lengths_of(const Axes& axes) {
  return {length(axes[0]), length(axes[1]), length(axes[2])};
}

void multiply(Vector& vector, const Vector& factors) {
  for (std::size_t i = 0; i < 3; ++i) vector[i] *= factors[i];
}

// ---- units ----

using Units = std::array<std::string, 3>;

void note_units(VolumeInfo& info, const Units& units) {
  for (const std::string& unit : units)
    if (unit.empty())
      note(info, "no unit of length given, mm assumed");
    else if (!millimetres_in(unit))
      note(info, "unit " + shown(unit) + " is unknown, mm assumed");
}

// Returns the length of each unit.
Vector millimetres_of(const Units& units) {
  Vector lengths{};
  std::transform(units.begin(), units.end(), lengths.begin(),
                 [](const std::string& unit) { return millimetres_in(unit).value_or(1); });
  return lengths;
}

// ---- spacing ----

Vector usable(VolumeInfo& info, Vector spacing_mm) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = std::fabs(spacing_mm[axis]);
    if (size >= min_spacing_mm && size <= max_spacing_mm) continue;
    note(info, "spacing " + short_number(spacing_mm[axis]) + " of axis " +
                   std::to_string(axis + 1) + " is unusable, 1 mm assumed");
    spacing_mm[axis] = 1;
  }
  return spacing_mm;
}

// Returns the spacing of a file without steps.
Vector spacing_of(VolumeInfo& info, const DeclaredPlace& place) {
  const auto& spacing = place.spacing;
  const auto is_given = [](const auto& distance) { return distance.has_value(); };
  if (std::none_of(spacing.begin(), spacing.end(), is_given)) {
    note(info, "no spacing given, 1 mm assumed");
    return {1, 1, 1};
  }
  note_units(info, place.axis_units);
  Vector spacing_mm = millimetres_of(place.axis_units);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!spacing[axis])
      note(info, "no spacing of axis " + std::to_string(axis + 1) + " given, 1 mm assumed");
    spacing_mm[axis] = spacing[axis] ? spacing_mm[axis] * *spacing[axis] : 1;
  }
  return usable(info, spacing_mm);
}

// Applies the user's spacing instead of the file's. Axes keep their directions.
Vector given_spacing(VolumeInfo& info, const DeclaredPlace& place, Vector spacing_mm) {
  for (std::size_t axis = 0; axis < 3 && !place.steps; ++axis)
    spacing_mm[axis] *= std::copysign(1.0, place.spacing[axis].value_or(1));
  return usable(info, spacing_mm);
}

void note_contradiction(VolumeInfo& info, const DeclaredPlace& place, const Vector& lengths_mm) {
  constexpr double rounding = 1e-3;
  const Vector units_mm = millimetres_of(place.axis_units);
  Vector spacing_mm = lengths_mm;
  bool is_same = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (place.spacing[axis]) spacing_mm[axis] = std::fabs(*place.spacing[axis] * units_mm[axis]);
    is_same =
        is_same && std::fabs(spacing_mm[axis] - lengths_mm[axis]) <= rounding * lengths_mm[axis];
  }
  if (!is_same)
    note(info, "spacing " + list(spacing_mm) + " contradicts the axes, whose " + list(lengths_mm) +
                   " mm is used");
}

// Lengths of atoms are too small for millimetres, so 1 nm becomes 1 mm, as 1 angstrom of MRC does.
DeclaredPlace of_atoms(VolumeInfo& info, DeclaredPlace place) {
  constexpr double max_mm = 1e-4, enlargement = 1e6;
  Vector lengths_mm = millimetres_of(place.steps ? place.space_units : place.axis_units);
  for (std::size_t axis = 0; axis < 3; ++axis)
    lengths_mm[axis] *=
        std::fabs(place.steps ? length((*place.steps)[axis]) : place.spacing[axis].value_or(0));
  const auto [least, most] = std::minmax_element(lengths_mm.begin(), lengths_mm.end());
  if (!(*least > 0 && *least < min_spacing_mm && *most < max_mm)) return place;
  note(info, "distances are " + list(lengths_mm) + " mm; 1 nm is written as 1 mm");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place.origin[axis] *= enlargement;
    if (place.spacing[axis]) *place.spacing[axis] *= enlargement;
    if (place.steps) multiply((*place.steps)[axis], {enlargement, enlargement, enlargement});
  }
  return place;
}

// ---- axes ----

// Sets the spacing without its signs, and returns the axes.
Axes separate_spacing(VolumeInfo& info, const DeclaredPlace& place, const VolumeOptions& options) {
  Axes axes = place.steps ? *place.steps : place.directions.value_or(coordinates);
  Vector lengths{1, 1, 1};
  if (place.steps) {
    for (Vector& step : axes) multiply(step, millimetres_of(place.space_units));
    lengths = lengths_of(axes);
  }
  if (options.spacing_mm) {
    info.spacing_mm = given_spacing(info, place, *options.spacing_mm);
  } else if (place.steps) {
    note_units(info, place.space_units);
    note_contradiction(info, place, lengths);
    info.spacing_mm = usable(info, lengths);
    return axes;
  } else {
    info.spacing_mm = spacing_of(info, place);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& along : axes[axis]) along *= info.spacing_mm[axis] / lengths[axis];
  return axes;
}

// Returns the sign of each axis if every axis is mostly along its coordinate, otherwise the sign of
// the whole.
Vector signs_of(const Axes& axes) {
  constexpr double mostly_along = 0.75;  // then no other component is larger
  Vector signs{};
  bool is_near = true;
  for (std::size_t i = 0; i < 3; ++i) {
    signs[i] = std::copysign(1.0, axes[i][i]);
    is_near = is_near && std::fabs(axes[i][i]) > mostly_along * length(axes[i]);
  }
  const double hand = std::copysign(1.0, determinant(axes));
  if (is_near && signs[0] * signs[1] * signs[2] == hand) return signs;
  return {1, 1, hand};
}

struct Unit {
  double millimetres;
  std::initializer_list<std::string_view> names;
};

// Words have British spelling and are singular. Micro has two characters in Unicode, one in
// Latin-1, and an escape in files of ImageJ.
const Unit length_units[] = {
    {1000, {"m", "metre"}},
    {100, {"dm", "decimetre"}},
    {10, {"cm", "centimetre"}},
    {1, {"mm", "millimetre"}},
    {1e-3, {"um", "\u00b5m", "\u03bcm", "\xb5m", "\\u00b5m", "micron", "micrometre"}},
    {1e-6, {"nm", "nanometre"}},
    {1e-7, {"\u00c5", "\u212b", "\xc5", "angstrom"}},
    {1e-9, {"pm", "picometre"}},
    {25.4, {"in", "inch", "\""}},
};

// Converts "Micrometers" to "micrometre".
std::string in_british_singular(std::string_view name) {
  std::string word = lower(trimmed(name));
  if (word == "inches") return "inch";
  if (word.size() > 3 && word.back() == 's') word.pop_back();
  const std::size_t at = word.size() - std::min<std::size_t>(word.size(), 5);
  if (word.substr(at) == "meter") word.replace(at, 5, "metre");
  return word;
}

}  // namespace

void set_place(VolumeInfo& info, const DeclaredPlace& declared, const VolumeOptions& options) {
  const DeclaredPlace place = options.spacing_mm ? declared : of_atoms(info, declared);
  VolumePlacement placement{place.space, place.origin, separate_spacing(info, place, options)};
  if (place.origin != Vector{}) note_units(info, place.space_units);
  multiply(placement.origin_mm, millimetres_of(place.space_units));
  if (place.is_left_handed) {
    for (Vector& axis : placement.axes_mm) axis[0] = -axis[0];
    placement.origin_mm[0] = -placement.origin_mm[0];
  }
  if (is_usable(placement.axes_mm)) {
    const Vector signs = signs_of(placement.axes_mm);
    for (std::size_t axis = 0; axis < 3; ++axis)
      info.spacing_mm[axis] = std::copysign(info.spacing_mm[axis], signs[axis]);
  } else {
    note(info, "the axis directions are unusable, the axes of the coordinates are used");
    placement.axes_mm = along_coordinates(info.spacing_mm).axes_mm;
  }
  if (!is_usable(placement)) {
    note(info, "origin " + list(placement.origin_mm) + " is unusable, 0 is used");
    placement.origin_mm = {};
  }
  // Adding zero turns -0 into 0.
  for (double& at : placement.origin_mm) at += 0.0;
  for (Vector& axis : placement.axes_mm)
    for (double& along : axis) along += 0.0;
  if (!(placement == along_coordinates(info.spacing_mm))) info.placement = placement;
}

std::optional<double> millimetres_in(std::string_view unit) {
  const std::string name = in_british_singular(unit);
  for (const Unit& each : length_units)
    if (std::find(each.names.begin(), each.names.end(), name) != each.names.end())
      return each.millimetres;
  return std::nullopt;
}

DeclaredValues declared_values(const std::function<std::optional<double>(const char*)>& number,
                               const std::string& sign) {
  DeclaredValues values;
  values.slope = number("scale_factor").value_or(1);
  values.intercept = number("add_offset").value_or(0);
  values.fill = number("_FillValue");
  if (!values.fill) values.fill = number("missing_value");
  if (lower(sign) == "true") values.is_unsigned = true;
  if (lower(sign) == "false") values.is_unsigned = false;
  return values;
}

std::optional<double> set_values(VolumeInfo& info, const std::string& file,
                                 const DeclaredValues& values) {
  std::optional<double> fill = values.fill;
  if (values.is_unsigned && !is_floating(info.type)) {
    const std::string bits(name(info.type).substr(1));
    info.type = *sample_type_called((*values.is_unsigned ? "u" : "i") + bits);
    const double all = std::ldexp(1, static_cast<int>(8 * sample_bytes(info.type)));
    if (fill && *values.is_unsigned && *fill < 0) *fill += all;
    if (fill && !*values.is_unsigned && *fill >= all / 2) *fill -= all;
  }
  set_scale(info, file, values.slope, values.intercept);
  return fill;
}

}  // namespace discmc::command
