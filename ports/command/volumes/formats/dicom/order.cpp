#include "order.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "distances.hpp"
#include "stack.hpp"
#include "text/number_text.hpp"
#include "vectors.hpp"
#include "volumes/formats/pictures/picture_names.hpp"
#include "volumes/gaps.hpp"
#include "volumes/told_place.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

using Frames = std::vector<DicomFrame>;
using Path = std::filesystem::path;

constexpr const char* export_again = "export or copy the series again";

void fill(const Path& source, VolumeInfo& info, Frames& stack,
          const std::vector<std::uint64_t>& numbers, const std::vector<std::string>& places,
          bool allow_gaps) {
  std::vector<Gap> gaps;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (const std::uint64_t missing = numbers[i] - numbers[i - 1] - 1; missing > 0)
      gaps.push_back({i - 1, std::min(missing, max_missing),
                      "between " + places[i - 1] + " and " + places[i]});
  if (gaps.empty()) return;
  note(info, note_of_filling(source, gaps, stack.size(), allow_gaps, export_again));
  fill_gaps(stack, gaps);
}

// ---- by position ----

// How far a frame lies along the normal of the stack. Units: millimetres.
class Along {
 public:
  explicit Along(const DicomFrame& first) : normal_(normal_of(*first.place)) {}
  double operator()(const DicomFrame& frame) const { return dot(frame.place->position, normal_); }

 private:
  Vector normal_;
};

// Drops frames that are there twice. Returns how many.
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
      fail(source,
           "two slices at " + short_number(along(frame)) + " mm differ: " + name_of(kept.back()) +
               " and " + name_of(frame) + ", and nothing tells which are of one volume",
           "give a pattern of the files of one volume, such as 'FOLDER/a*'");
  }
  const std::size_t dropped = stack.size() - kept.size();
  stack = std::move(kept);
  return dropped;
}

// How far the coordinates of positions may be from the true ones, where they are rounded.
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

double along_normal_of(const Frames& stack, const Vector& rounding) {
  const Vector normal = normal_of(*stack[0].place);
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) most += std::fabs(normal[i]) * rounding[i];
  return most;
}

bool are_mostly_neighbours(const std::vector<std::uint64_t>& numbers) {
  std::size_t neighbours = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) neighbours += numbers[i] == numbers[i - 1] + 1;
  return 2 * neighbours >= numbers.size() - 1;
}

// The slices as positions that are rounded have them, with the step that the file tells if it fits.
std::optional<EvenSlices> rounded_slices(const std::vector<double>& along, double told_step,
                                         double rounding) {
  for (const double step : {told_step, best_step(along)})
    if (auto slices = slices_by_step(along, step, rounding))
      if (are_mostly_neighbours(slices->numbers)) return slices;
  return std::nullopt;
}

EvenSlices even_slices(const Path& source, VolumeInfo& info, const Frames& stack,
                       const std::vector<double>& along) {
  OddDistance odd;
  const double rounding = along_normal_of(stack, rounding_of(stack));
  auto slices = slices_by_distances(along, odd);
  if (!slices) {
    slices = rounded_slices(along, std::fabs(stack[0].slice_spacing_mm), rounding);
    if (slices)
      note(info,
           "the positions are rounded, slices taken " + short_number(slices->step) + " mm apart");
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
  constexpr double max_share = 0.25, share_to_tell = 0.02;
  if (off > std::max(rounding, share_to_tell * slices->step))
    note(info, "slices lie up to " + short_number(off) + " mm from where even distances have them");
  if (off > max_share * slices->step)
    fail(source,
         "the distances of slices change: with " + short_number(slices->step) +
             " mm everywhere some would be " + short_number(off) + " mm off",
         "resample the series to even distances, e.g. with 3D Slicer or dcm2niix");
  return *slices;
}

// The way to the next slice: along the normal, or aside, too, as with a tilted gantry.
Vector step_of(const Path& source, VolumeInfo& info, const Frames& stack,
               const EvenSlices& slices) {
  const Vector& first = stack[0].place->position;
  const Vector normal = normal_of(*stack[0].place);
  const auto aside = [&](std::size_t i) {
    const Vector way = sum(stack[i].place->position, -1, first);
    return sum(way, -dot(way, normal), normal);
  };
  constexpr double least_mm = 0.001, share = 0.1, straight_share = 0.02;  // of a voxel
  const double voxel = std::min(stack[0].spacing_mm[0], stack[0].spacing_mm[1]);
  // That of a position, and of the two that the line goes through.
  const double rounding = std::max(least_mm, 2 * length(rounding_of(stack)));
  const auto last = static_cast<double>(slices.numbers.back());
  const Vector shift = sum({}, 1 / last, aside(stack.size() - 1));
  bool is_straight = true;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const auto number = static_cast<double>(slices.numbers[i]);
    is_straight = is_straight && length(aside(i)) <= std::max(rounding, straight_share * voxel);
    const double off = length(sum(aside(i), -number, shift));
    if (off > std::max(rounding, share * voxel))
      fail(source,
           name_of(stack[i]) + " is shifted aside by " + short_number(off) +
               " mm against the line of the others",
           "resample the series to a straight one, e.g. with 3D Slicer");
  }
  const Vector straight = sum({}, slices.step, normal);
  if (is_straight) return straight;
  constexpr double degrees = 180 / 3.14159265358979323846;
  note(info, "each slice is shifted by " + short_number(length(shift)) +
                 " mm against the one before it, as by a gantry tilted by " +
                 short_number(std::atan2(length(shift), slices.step) * degrees) +
                 " degrees; the volume is sheared as they lie");
  // That of the positions themselves, unless they are rounded.
  const Vector way = sum({}, 1 / last, sum(stack.back().place->position, -1, first));
  constexpr double same_mm = 1e-6;
  return std::fabs(dot(way, normal) - slices.step) < same_mm ? way : sum(straight, 1, shift);
}

SliceLine order_by_position(const Path& source, VolumeInfo& info, Frames& stack,
                            const SamePixels& same_pixels, bool allow_gaps) {
  const Along along_normal(stack[0]);
  std::stable_sort(stack.begin(), stack.end(), [&](const DicomFrame& a, const DicomFrame& b) {
    return along_normal(a) < along_normal(b);
  });
  if (const std::size_t dropped = drop_duplicates(source, stack, along_normal, same_pixels);
      dropped > 0)
    note(info, std::to_string(dropped) + (dropped == 1 ? " slice that is there twice dropped"
                                                       : " slices that are there twice dropped"));
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
                          step_of(source, info, stack, slices)};
  places.back() += ", where the others are " + short_number(slices.step) + " mm apart";
  fill(source, info, stack, slices.numbers, places, allow_gaps);
  return line;
}

// ---- otherwise ----

void order_by_instance(const Path& source, VolumeInfo& info, Frames& stack, bool allow_gaps) {
  for (const DicomFrame& frame : stack)
    if (!frame.image->instance_number)
      fail(source, name_of(frame) + " has no InstanceNumber", "put them in order by --order name");
  const auto key = [](const DicomFrame& frame) {
    return std::pair(*frame.image->instance_number, frame.number);
  };
  std::stable_sort(stack.begin(), stack.end(),
                   [&](const DicomFrame& a, const DicomFrame& b) { return key(a) < key(b); });
  std::vector<std::uint64_t> numbers;
  std::vector<std::string> places;
  for (const DicomFrame& frame : stack) {
    numbers.push_back(static_cast<std::uint64_t>(std::int64_t{*frame.image->instance_number} -
                                                 *stack[0].image->instance_number));
    places.push_back("instance " + std::to_string(*frame.image->instance_number) + " (" +
                     name_of(frame) + ")");
  }
  for (std::size_t i = 1; i < stack.size(); ++i)
    if (key(stack[i]) == key(stack[i - 1]))
      fail(source, "two slices have one InstanceNumber: " + places[i - 1] + " and " + places[i],
           "put them in order by --order name");
  const bool is_one_file = stack.front().image == stack.back().image;
  if (!is_one_file) fill(source, info, stack, numbers, places, allow_gaps);
}

void order_by_name(Frames& stack) {
  std::vector<Path> files;
  for (const DicomFrame& frame : stack) files.push_back(frame.image->file);
  sort_naturally(files);
  std::map<Path, std::size_t> ranks;
  for (const Path& file : files) ranks.emplace(file, ranks.size());
  const auto key = [&](const DicomFrame& frame) {
    return std::pair(ranks.at(frame.image->file), frame.number);
  };
  std::stable_sort(stack.begin(), stack.end(),
                   [&](const DicomFrame& a, const DicomFrame& b) { return key(a) < key(b); });
}

void order_without_positions(const Path& source, VolumeInfo& info, Frames& stack,
                             const VolumeOptions& options) {
  const std::string and_sides =
      "; which way they follow each other, and so which side is left, is not known";
  if (options.order == SliceOrder::instance) {
    order_by_instance(source, info, stack, options.allow_gaps);
    note(info, "slices in the order of their InstanceNumber" + and_sides);
  } else if (options.order == SliceOrder::name) {
    order_by_name(stack);
    note(info, "slices in the order of their names" + and_sides);
  } else if (std::any_of(stack.begin(), stack.end(),
                         [&](const DicomFrame& frame) { return frame.image != stack[0].image; })) {
    fail(source,
         "the " + std::to_string(stack.size()) +
             " slices tell no position (ImagePositionPatient), and so no order",
         "put them in order by --order instance (InstanceNumber) or --order name");
  } else if (stack.size() > 1) {
    note(info, "the frames tell no positions, taken in their order" + and_sides);
  }
}

// ---- the volume ----

void require_one_spacing(const Path& source, const Frames& stack) {
  constexpr double tolerance = 1e-4;
  for (const DicomFrame& frame : stack)
    for (std::size_t i = 0; i < 2; ++i) {
      const double first = stack[0].spacing_mm[i];
      if (std::fabs(frame.spacing_mm[i] - first) > tolerance * std::fabs(first))
        fail(source,
             "voxels are " + short_number(first) + " mm apart in " + name_of(stack[0]) + " and " +
                 short_number(frame.spacing_mm[i]) + " mm in " + name_of(frame),
             "resample the slices to one size of voxels");
    }
}

void set_values(VolumeInfo& info, const Path& source, const Frames& stack) {
  // Throws where one is of no use.
  for (const DicomFrame& frame : stack) set_scale(info, source, frame.slope, frame.intercept);
  info.type = stack[0].image->type;
  // The values of CT that are not shifted may be of any unit.
  info.is_in_hounsfield = stack[0].image->modality == "CT" && info.intercept < 0;
  if (have_one_scale(stack)) {
    const DicomImage& image = *stack[0].image;
    if (image.padding && !image.is_inverted)
      info.padding = info.slope * *image.padding + info.intercept;
    return;
  }
  info.type = SampleType::f32;
  info.slope = 1;
  info.intercept = 0;
  note(info, "slope and intercept differ from slice to slice, values taken as f32");
}

}  // namespace

void set_slice_line(VolumeInfo& info, const DicomFrame& first, const std::optional<SliceLine>& line,
                    const VolumeOptions& options) {
  const double distance = line ? length(line->step) : std::fabs(first.slice_spacing_mm);
  const std::string name = first.spacing_name == nullptr ? "" : first.spacing_name;
  if (!options.spacing_mm) {
    if (name.empty())
      note(info, "no PixelSpacing, 1 mm taken");
    else if (name != "PixelSpacing")
      note(info, "no PixelSpacing, " + name + " taken, which is that at the detector");
    if (distance == 0) note(info, "no SpacingBetweenSlices or SliceThickness, 1 mm taken");
  }
  const auto or_one = [](double told) { return told == 0 ? 1 : told; };
  ToldPlace told;
  told.set_unit("mm");
  told.spacing = {or_one(first.spacing_mm[0]), or_one(first.spacing_mm[1]), or_one(distance)};
  if (line) {
    told.frame = Frame::lps;
    told.origin = line->origin;
    const Vector across =
        distance == 0 ? normal_of(*first.place) : sum({}, 1 / distance, line->step);
    told.directions = {first.place->along_row, first.place->along_column, across};
  }
  set_place(info, told, options);
}

bool have_one_scale(const Frames& stack) {
  return std::all_of(stack.begin(), stack.end(), [&](const DicomFrame& frame) {
    return frame.slope == stack[0].slope && frame.intercept == stack[0].intercept;
  });
}

void order_stack(const Path& source, Frames& stack, const SamePixels& same_pixels,
                 const VolumeOptions& options, VolumeInfo& info) {
  std::optional<SliceLine> line;
  if (stack[0].place && options.order == SliceOrder::position) {
    line = order_by_position(source, info, stack, same_pixels, options.allow_gaps);
  } else {
    order_without_positions(source, info, stack, options);
  }
  require_one_spacing(source, stack);
  const DicomImage& image = *stack[0].image;
  set_dims(info, source, {image.columns, image.rows, static_cast<std::int64_t>(stack.size())});
  set_values(info, source, stack);
  set_slice_line(info, stack[0], line, options);
  for (const DicomFrame& frame : stack)
    for (const std::string& each : frame.image->notes) note(info, each);
  if (image.is_inverted)
    note(info, "MONOCHROME1: the low values are the bright ones, taken as stored");
  info.format = "DICOM";
  if (!image.compression.empty()) info.format += ", " + image.compression;
}

}  // namespace discmc::command
