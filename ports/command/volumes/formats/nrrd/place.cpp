#include "header.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "text/words.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// Parses the units of three axes, each in double quotes or a single word.
std::array<std::string, 3> units_of(std::string_view text) {
  std::array<std::string, 3> units;
  for (std::string& unit : units) {
    text = trimmed(text);
    const bool is_quoted = !text.empty() && text.front() == '"';
    if (is_quoted) text.remove_prefix(1);
    const std::size_t end = std::min(text.find_first_of(is_quoted ? "\"" : " \t"), text.size());
    unit = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return units;
}

// Parses "(x,y,z)". ITK writes a fourth number, the time.
std::vector<double> vector_of(const HeaderFields& fields, std::string_view name,
                              std::string_view text) {
  const std::filesystem::path& file = fields.file();
  const bool has_time = trimmed(fields.text("space dimension")) == "4";
  std::vector<double> numbers;
  const bool bracketed = text.size() >= 2 && text.front() == '(' && text.back() == ')';
  while (bracketed && numbers.size() <= 4) {
    text.remove_prefix(1);
    const std::size_t end = text.find_first_of(",)");
    numbers.push_back(real(file, name, trimmed(text.substr(0, end))));
    text.remove_prefix(end);
    if (text.size() == 1) break;
  }
  if (has_time && numbers.size() == 4) numbers.pop_back();
  if (numbers.empty() || numbers.size() > 3)
    fail(file,
         std::string(name) + " holds " + shown(text) + ", which is not a vector of up to three",
         "correct the header");
  return numbers;
}

// A field per axis must have a value for every axis.
void expect_per_axis(const HeaderFields& fields, std::string_view name, std::size_t found) {
  const std::size_t axes = words(fields.text("sizes")).size();
  if (found < std::min<std::size_t>(axes, 3))
    fail(fields.file(),
         std::string(name) + " holds " + std::to_string(found) + " entries for " +
             std::to_string(axes) + " dimensions",
         "correct the header");
}

Axes directions_of(const HeaderFields& fields) {
  std::string_view text = fields.text("space directions");
  Axes directions = coordinates;
  std::size_t axis = 0;
  for (; axis < 3 && !trimmed(text).empty(); ++axis) {
    text = trimmed(text);
    const std::size_t end = text.front() == '(' ? text.find(')') : text.find_first_of(" \t");
    const std::string_view word = text.substr(0, end == std::string_view::npos ? end : end + 1);
    text.remove_prefix(word.size());
    if (lower(trimmed(word)) == "none") fail_axis(fields, axis, "has no direction in space");
    const auto numbers = vector_of(fields, "space directions", trimmed(word));
    directions[axis] = {0, 0, 0};
    std::copy(numbers.begin(), numbers.end(), directions[axis].begin());
  }
  expect_per_axis(fields, "space directions", axis);
  return directions;
}

using Numbers = std::array<std::optional<double>, 3>;

// Returns the values of a field for the first three axes; "nan" means unknown.
Numbers numbers_of(const HeaderFields& fields, std::string_view name) {
  const auto parts = words(fields.text(name));
  if (!parts.empty()) expect_per_axis(fields, name, parts.size());
  Numbers numbers;
  for (std::size_t axis = 0; axis < 3 && axis < parts.size(); ++axis) {
    const double number = real(fields.file(), name, parts[axis]);
    if (!std::isnan(number)) numbers[axis] = number;
  }
  return numbers;
}

// The bounds of axes define a spacing, and the origin if no field does.
void set_bounds(VolumeInfo& info, const HeaderFields& fields, DeclaredPlace& place) {
  const Numbers mins = numbers_of(fields, "axis mins");
  const Numbers maxs = numbers_of(fields, "axis maxs");
  const auto centerings = words(fields.text("centerings"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!mins[axis]) continue;
    const std::string center = axis < centerings.size() ? lower(centerings[axis]) : std::string();
    const bool is_node = center == "node";
    if (!is_node && center != "cell")
      note(info, "no centerings given; axis mins and maxs are read as bounds of whole voxels");
    const double steps = info.dims[axis] - (is_node ? 1.0 : 0.0);
    if (maxs[axis] && steps > 0) {
      const double spacing = (*maxs[axis] - *mins[axis]) / steps;
      if (!place.spacing[axis]) place.spacing[axis] = spacing;
      if (std::fabs(*place.spacing[axis] - spacing) > 1e-3 * std::fabs(spacing))
        note(info, "axis mins and maxs contradict the spacings, which are used");
    }
    place.origin[axis] = *mins[axis] + (is_node ? 0 : place.spacing[axis].value_or(1) / 2);
  }
  if (fields.has("axis mins")) place.space_units = place.axis_units;
}

// Sets the place of a volume without directions.
void set_spacings(VolumeInfo& info, const HeaderFields& fields, DeclaredPlace& place) {
  place.spacing = numbers_of(fields, "spacings");
  if (!fields.has("space origin")) set_bounds(info, fields, place);
  const Numbers thicknesses = numbers_of(fields, "thicknesses");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (place.spacing[axis] || !thicknesses[axis]) continue;
    place.spacing[axis] = thicknesses[axis];
    note(info, "no spacing of axis " + std::to_string(axis + 1) + " given, its thickness is used");
  }
}

// Sets the space of the coordinates.
void set_space(VolumeInfo& info, std::string_view text, DeclaredPlace& place) {
  std::string name = lower(text);
  constexpr std::string_view time = "-time";
  if (name.size() > time.size() && name.substr(name.size() - time.size()) == time)
    name.resize(name.size() - time.size());
  if (one_of(name, {"left-posterior-superior", "lps", "lpst"})) place.space = Space::lps;
  if (one_of(name, {"right-anterior-superior", "ras", "rast"})) place.space = Space::ras;
  if (one_of(name, {"left-anterior-superior", "las", "last"})) place.space = Space::ras;
  place.is_left_handed = one_of(name, {"left-anterior-superior", "las", "last", "3d-left-handed"});
  if (name == "3d-left-handed")
    note(info, "x of the left-handed space " + shown(text) + " negated");
  const bool is_defined = place.space != Space::scanner || place.is_left_handed || name.empty() ||
                          one_of(name, {"scanner-xyz", "3d-right-handed"});
  if (!is_defined) note(info, "the space " + shown(text) + " is unknown, right-handed assumed");
}

}  // namespace

DeclaredPlace nrrd_place(VolumeInfo& info, const HeaderFields& fields) {
  DeclaredPlace place;
  set_space(info, fields.text("space"), place);
  // The space of patients is in millimetres, as programs that write no unit assume.
  if (place.space != Space::scanner) place.set_unit("mm");
  if (fields.has("units")) place.axis_units = units_of(fields.text("units"));
  if (fields.has("space units")) place.space_units = units_of(fields.text("space units"));
  if (fields.text("space directions").empty())
    set_spacings(info, fields, place);
  else
    place.steps = directions_of(fields);
  if (const std::string_view origin = fields.text("space origin"); !origin.empty()) {
    const auto numbers = vector_of(fields, "space origin", origin);
    std::copy(numbers.begin(), numbers.end(), place.origin.begin());
  }
  if ((fields.has("axis mins") || fields.has("axis maxs")) &&
      (fields.has("space origin") || fields.has("space directions")))
    note(info, "axis mins and axis maxs are ignored; space directions or origin define the place");
  return place;
}

}  // namespace discmc::command
