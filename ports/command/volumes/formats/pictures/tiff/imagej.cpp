#include "descriptions.hpp"

#include <cmath>
#include <map>
#include <string>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// Lines of "key=value".
class Description {
 public:
  Description(const std::filesystem::path& file, std::string_view text) : file_(file) {
    while (const auto line = next_line(text)) {
      const std::size_t equals = line->find('=');
      if (equals != std::string_view::npos)
        values_.emplace(trimmed(line->substr(0, equals)), trimmed(line->substr(equals + 1)));
    }
  }

  std::string_view text(std::string_view key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string_view() : found->second;
  }

  /// Returns 0 if the key is missing.
  std::uint64_t count(std::string_view key) const {
    if (text(key).empty()) return 0;
    const auto value = whole_number<std::uint64_t>(text(key));
    if (!value || *value == 0)
      fail(file_, "in the description " + std::string(key) + " is " + shown(text(key)),
           "export the file again");
    return *value;
  }

  double number(std::string_view key, double otherwise) const {
    return text(key).empty() ? otherwise : real(file_, key, text(key));
  }

 private:
  std::filesystem::path file_;
  std::map<std::string_view, std::string_view> values_;
};

// Sets the axes and their order.
void set_axes(Hyperstack& stack, const Description& description, const TiffFacts& facts) {
  const auto at_least_1 = [&](std::string_view key) {
    return std::max<std::uint64_t>(1, description.count(key));
  };
  stack.slices.size = at_least_1("slices");
  stack.channels.size = at_least_1("channels");
  stack.frames.size = at_least_1("frames");
  // Colours are samples of a pixel, but some programs count them as planes, too.
  if (stack.channels.size == facts.samples) stack.channels.size = 1;
  const std::uint64_t images = description.count("images");
  if (planes(stack) == 1) stack.slices.size = images > 0 ? images : facts.pages;
  const std::string_view order = description.text("order");
  set_order(stack, order.empty() || order == "default" ? "czt" : lower(order));
}

void set_spacing(Hyperstack& stack, const Description& description, const TiffFacts& facts) {
  const std::string unit(description.text("unit"));
  const auto mm = millimetres_in(unit);
  if (!mm) {
    std::string text =
        unit.empty() ? "it has no unit" : "its unit is " + shown(unit) + ", which is not a length";
    const auto pixel = [&](std::size_t axis) {
      return facts.resolution[axis] > 0 ? 1 / facts.resolution[axis] : 1;
    };
    const double x = pixel(0), y = pixel(1), z = std::fabs(description.number("spacing", x));
    const bool is_cube = x == y && y == z;
    if (!is_cube)
      text += "; if it is mm, give --spacing " + short_number(x) + ',' + short_number(y) + ',' +
              short_number(z);
    if (!is_cube || !unit.empty()) stack.notes.push_back(text);
    return;
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (facts.resolution[axis] > 0) stack.spacing_mm[axis] = *mm / facts.resolution[axis];
  const std::string_view unit_of_z = description.text("zunit");
  const auto mm_of_z = unit_of_z.empty() ? mm : millimetres_in(unit_of_z);
  const bool has_distance = !description.text("spacing").empty();
  if (mm_of_z && (has_distance || stack.slices.size > 1))
    stack.spacing_mm[2] = *mm_of_z * std::fabs(description.number("spacing", 1));
  if (!has_distance && stack.slices.size > 1)
    stack.notes.emplace_back("no distance of slices given, 1 unit assumed, as by ImageJ");
}

// Sets the calibration of grey values, such as CT values, which ImageJ stores from 0 on.
void set_calibration(Hyperstack& stack, const Description& description) {
  constexpr std::string_view straight_line = "0";
  const std::string_view function = description.text("cf");
  if (function.empty()) return;
  if (function == straight_line) {
    stack.slope = description.number("c1", 1);
    stack.intercept = description.number("c0", 0);
  } else {
    stack.notes.push_back("its calibration function " + shown(function) +
                          " is not supported, and the samples are used as stored");
  }
}

}  // namespace

bool is_imagej(std::string_view description) {
  return description.rfind("ImageJ=", 0) == 0;
}

Hyperstack imagej_stack(const TiffFacts& facts, std::string_view description) {
  const Description fields(facts.file, description);
  Hyperstack stack;
  set_axes(stack, fields, facts);
  set_spacing(stack, fields, facts);
  set_calibration(stack, fields);
  stack.origin_voxel = {fields.number("xorigin", 0), fields.number("yorigin", 0),
                        fields.number("zorigin", 0)};
  stack.files = {facts.file};
  stack.runs = {{0, 0, 0, planes(stack)}};
  return stack;
}

}  // namespace discmc::command
