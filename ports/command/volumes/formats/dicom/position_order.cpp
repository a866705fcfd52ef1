#include "order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "stack.hpp"
#include "text/number_text.hpp"
#include "volumes/gaps.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

using Frames = std::vector<DicomFrame>;
using Path = std::filesystem::path;

// Computes the position of a frame along the normal of the stack. Units: millimetres.
class Along {
 public:
  explicit Along(const DicomFrame& first) : normal_(normal_of(*first.place)) {}
  double operator()(const DicomFrame& frame) const { return dot(frame.place->position, normal_); }

 private:
  Vector normal_;
};

// Refuses two slices at one position. kept: the frames before `frame`; the last one has its
// position.
[[noreturn]] void fail_in_one_place(const Path& source, const Frames& stack, const Frames& kept,
                                    const DicomFrame& frame, const Along& along) {
  std::map<double, std::size_t> places;  // keyed by thousandths of a millimetre
  for (const DicomFrame& each : stack) ++places[std::round(1000 * along(each))];
  std::vector<double> twice;
  for (const auto& [place, count] : places)
    if (count > 1) twice.push_back(place / 1000);
  const bool is_one_file = frame.image == kept.back().image;
  fail(source,
       "two slices at " + short_number(along(frame)) + " mm differ: " + name_of(kept.back()) +
           " and " + name_of(frame) + ", and no attribute separates their volumes; " +
           std::to_string(twice.size()) + " of " + std::to_string(places.size()) +
           " places hold several slices, from " + short_number(twice.front()) + " to " +
           short_number(twice.back()) + " mm",
       is_one_file ? "read the frames in their order with --order instance, or split the file"
                   : "give a pattern of the files of one volume, such as 'FOLDER/a*', or move " +
                         name_of(frame) + " away");
}

// Removes duplicate frames. Returns their number.
std::size_t drop_duplicates(const Path& source, Frames& stack, const Along& along,
                            const SamePixels& same_pixels) {
  constexpr double same_mm = 1e-5;
  Frames kept;
  for (const DicomFrame& frame : stack) {
    if (kept.empty() || along(frame) - along(kept.back()) > same_mm) {
      kept.push_back(frame);
      continue;
    }
    const bool is_same_object = !frame.image->instance.empty() &&
                                frame.image->instance == kept.back().image->instance &&
                                frame.number == kept.back().number;
    if (!is_same_object && !same_pixels(frame, kept.back()))
      fail_in_one_place(source, stack, kept, frame, along);
  }
  const std::size_t dropped = stack.size() - kept.size();
  stack = std::move(kept);
  return dropped;
}

// Returns the possible rounding error of the coordinates of positions.
Vector rounding_of(const Frames& stack) {
  Vector rounding{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> numbers;
    for (const DicomFrame& frame : stack) numbers.push_back(frame.place->position[i]);
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    if (*least < *most) rounding[i] = half_a_decimal(numbers);
  }
  return rounding;
}

double rounding_along_normal(const Frames& stack, const Vector& rounding) {
  const Vector normal = normal_of(*stack[0].place);
  double rounding_along = 0;
  for (std::size_t i = 0; i < 3; ++i) rounding_along += std::fabs(normal[i]) * rounding[i];
  return rounding_along;
}

bool are_mostly_neighbours(const std::vector<std::uint64_t>& numbers) {
  std::size_t neighbours = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) neighbours += numbers[i] == numbers[i - 1] + 1;
  return 2 * neighbours >= numbers.size() - 1;
}

// Returns the slices by rounded positions, with the declared step if it fits.
std::optional<EvenSlices> rounded_slices(const std::vector<double>& along, double declared_step,
                                         double rounding) {
  for (const double step : {declared_step, best_step(along)})
    if (auto slices = slices_by_step(along, step, rounding))
      if (are_mostly_neighbours(slices->numbers)) return slices;
  return std::nullopt;
}

EvenSlices even_slices(const Path& source, VolumeInfo& info, const Frames& stack,
                       const std::vector<double>& along) {
  OddDistance odd;
  const double rounding = rounding_along_normal(stack, rounding_of(stack));
  auto slices = slices_by_distances(along, same_distance, odd);
  if (!slices) {
    slices = rounded_slices(along, std::fabs(stack[0].slice_spacing_mm), rounding);
    if (slices)
      note(info, "the positions are rounded, slices assumed to be " + short_number(slices->step) +
                     " mm apart");
  }
  constexpr double max_jitter = 0.1;  // of a step
  if (!slices) {
    slices = slices_by_distances(along, max_jitter, odd);
    if (slices && slices->numbers.back() + 1 != along.size()) slices.reset();  // not with gaps
  }
  if (!slices) {
    const DicomFrame& before = stack[odd.slice];
    const DicomFrame& after = stack[odd.slice + 1];
    fail(source,
         "the slices are " + short_number(odd.step) + " mm apart, but " +
             short_number(along[odd.slice + 1] - along[odd.slice]) + " mm between " +
             short_number(along[odd.slice]) + " mm (" + name_of(before) + ") and " +
             short_number(along[odd.slice + 1]) + " mm (" + name_of(after) + ")",
         "resample the series to even distances, e.g. with 3D Slicer or dcm2niix");
  }
  const double off = farthest_off(along, *slices);
  constexpr double max_share = 0.25;
  if (off > std::max(rounding, same_distance * slices->step))
    note(info, "slices lie up to " + short_number(off) + " mm from their place at even distances");
  if (off > max_share * slices->step)
    fail(source,
         "the distances of slices vary: with " + short_number(slices->step) +
             " mm everywhere, slices would be " + short_number(off) + " mm off",
         "resample the series to even distances, e.g. with 3D Slicer or dcm2niix");
  return *slices;
}

}  // namespace

Vector slice_step(const Path& source, VolumeInfo& info, const Frames& stack,
                  const EvenSlices& slices) {
  if (stack.size() == 1) return sum({}, slices.step, normal_of(*stack[0].place));
  const Vector& first = stack[0].place->position;
  const Vector normal = normal_of(*stack[0].place);
  const auto aside = [&](std::size_t i) {
    const Vector offset = sum(stack[i].place->position, -1, first);
    return sum(offset, -dot(offset, normal), normal);
  };
  constexpr double min_mm = 0.001, share = 0.25, straight_share = 0.02;  // shares of a voxel
  const double voxel = std::min(stack[0].spacing_mm[0], stack[0].spacing_mm[1]);
  // The error of a position, plus the errors of the two positions that define the line.
  const double rounding = std::max(min_mm, 2 * length(rounding_of(stack)));
  const auto last = static_cast<double>(slices.numbers.back());
  const Vector shift = sum({}, 1 / last, aside(stack.size() - 1));
  double max_aside = 0, max_off = 0, max_jump = 0;
  std::size_t after_jump = 1;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    max_aside = std::max(max_aside, length(aside(i)));
    max_off =
        std::max(max_off, length(sum(aside(i), -static_cast<double>(slices.numbers[i]), shift)));
    const double jump = i == 0 ? 0 : length(sum(aside(i), -1, aside(i - 1)));
    if (jump > max_jump) after_jump = i;
    max_jump = std::max(max_jump, jump);
  }
  const Vector straight = sum({}, slices.step, normal);
  if (max_aside <= std::max(rounding, straight_share * voxel)) return straight;
  const double allowed = std::max(rounding, share * voxel);
  if (max_aside <= allowed && max_off > std::max(rounding, straight_share * voxel)) {
    note(info, "slices lie up to " + short_number(max_aside) + " mm aside of a straight line");
    return straight;
  }
  if (max_off > allowed)
    fail(source,
         "the slices are not on one line: " + name_of(stack[after_jump]) +
             " is shifted sideways by " + short_number(max_jump) + " mm against " +
             name_of(stack[after_jump - 1]),
         "resample the series to a straight line, e.g. with 3D Slicer");
  constexpr double degrees = 180 / 3.14159265358979323846;
  note(info, "each slice is shifted by " + short_number(length(shift)) +
                 " mm against the one before it, as by a gantry tilted by " +
                 short_number(std::atan2(length(shift), slices.step) * degrees) +
                 " degrees; the volume is sheared accordingly");
  // Uses the positions themselves unless they are rounded.
  const Vector step = sum({}, 1 / last, sum(stack.back().place->position, -1, first));
  constexpr double same_mm = 1e-6;
  return std::fabs(dot(step, normal) - slices.step) < same_mm ? step : sum(straight, 1, shift);
}

void fill_missing(const Path& source, VolumeInfo& info, Frames& stack,
                  const std::vector<std::uint64_t>& numbers, const std::vector<std::string>& places,
                  bool allow_gaps) {
  std::vector<Gap> gaps;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (numbers[i] > numbers[i - 1] + 1)
      gaps.push_back({i - 1, std::min(numbers[i] - numbers[i - 1] - 1, max_missing),
                      "between " + places[i - 1] + " and " + places[i]});
  if (gaps.empty()) return;
  note(info,
       note_of_filling(source, gaps, stack.size(), allow_gaps, "export or copy the series again"));
  fill_gaps(stack, gaps);
}

SliceLine order_by_position(const Path& source, VolumeInfo& info, Frames& stack,
                            const SamePixels& same_pixels, bool allow_gaps) {
  const Along along_normal(stack[0]);
  std::stable_sort(stack.begin(), stack.end(), [&](const DicomFrame& a, const DicomFrame& b) {
    return along_normal(a) < along_normal(b);
  });
  if (const std::size_t dropped = drop_duplicates(source, stack, along_normal, same_pixels);
      dropped > 0)
    note(info, std::to_string(dropped) + (dropped == 1 ? " slice that occurs twice is dropped"
                                                       : " slices that occur twice are dropped"));
  const Vector normal = normal_of(*stack[0].place);
  if (stack.size() == 1)
    return {stack[0].place->position, sum({}, std::fabs(stack[0].slice_spacing_mm), normal)};
  std::vector<double> along;
  std::vector<std::string> places;
  for (const DicomFrame& frame : stack) {
    along.push_back(along_normal(frame));
    places.push_back(short_number(along.back()) + " mm (" + name_of(frame) + ")");
  }
  const EvenSlices slices = even_slices(source, info, stack, along);
  const SliceLine line = {sum(stack[0].place->position, slices.first - along[0], normal),
                          slice_step(source, info, stack, slices)};
  places.back() += ", and the others are " + short_number(slices.step) + " mm apart";
  fill_missing(source, info, stack, slices.numbers, places, allow_gaps);
  return line;
}

}  // namespace discmc::command
