#include "vtk_image.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "text/number_text.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

std::string text_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + short_number(number);
  return text;
}

}  // namespace

VtkExtent vtk_extent(const std::filesystem::path& file, std::string_view name,
                     const std::vector<double>& numbers) {
  const auto is_possible = [](double number) {
    constexpr double max_coordinate =
        1e12;  // differences, and products with a spacing, are still exact
    return std::fabs(number) <= max_coordinate && number == std::floor(number);
  };
  VtkExtent extent{};
  if (numbers.size() != extent.size() || !std::all_of(numbers.begin(), numbers.end(), is_possible))
    fail(file, std::string(name) + " is " + shown(text_of(numbers)),
         "give the first and the last point of three axes");
  std::transform(numbers.begin(), numbers.end(), extent.begin(),
                 [](double number) { return static_cast<std::int64_t>(number); });
  return extent;
}

std::int64_t vtk_size(const VtkExtent& extent, std::size_t axis, bool is_of_cells) {
  return extent[2 * axis + 1] - extent[2 * axis] + (is_of_cells ? 0 : 1);
}

DeclaredPlace declared_place(const std::filesystem::path& file, const std::vector<double>& spacing,
                             const std::vector<double>& origin,
                             const std::vector<double>& direction, const VtkExtent& extent,
                             bool is_of_cells) {
  const std::tuple<const char*, const std::vector<double>&, std::size_t> fields[] = {
      {"Spacing", spacing, 3}, {"Origin", origin, 3}, {"Direction", direction, 9}};
  for (const auto& [name, numbers, count] : fields)
    if (!numbers.empty() && numbers.size() != count)
      fail(file,
           std::string(name) + " is " + shown(text_of(numbers)) + ", which is not " +
               std::to_string(count) + " numbers",
           "correct it");
  DeclaredPlace place;
  std::copy(spacing.begin(), spacing.end(), place.spacing.begin());
  std::copy(origin.begin(), origin.end(), place.origin.begin());
  Axes& directions = place.directions.emplace(coordinates);
  for (std::size_t i = 0; i < direction.size(); ++i) directions[i % 3][i / 3] = direction[i];
  // The origin is the point with index 0, half a step before the centre of a cell.
  const double before = is_of_cells ? 0.5 : 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t row = 0; row < 3; ++row)
      place.origin[row] += (static_cast<double>(extent[2 * axis]) + before) *
                           directions[axis][row] * place.spacing[axis].value_or(1);
  return place;
}

}  // namespace discmc::command
