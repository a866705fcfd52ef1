#include "order.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "stack.hpp"
#include "text/number_text.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/pictures/picture_names.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

using Frames = std::vector<DicomFrame>;
using Path = std::filesystem::path;

void order_by_instance(const Path& source, VolumeInfo& info, Frames& stack, bool allow_gaps) {
  for (const DicomFrame& frame : stack)
    if (!frame.image->instance_number)
      fail(source, name_of(frame) + " has no InstanceNumber", "order the slices with --order name");
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
      fail(source,
           "two slices have the same InstanceNumber: " + places[i - 1] + " and " + places[i],
           "order the slices with --order name");
  const bool is_one_file = stack.front().image == stack.back().image;
  if (!is_one_file) fill_missing(source, info, stack, numbers, places, allow_gaps);
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
  const std::string and_sides = "; their direction, and so which side is left, is unknown";
  if (options.order == SliceOrder::instance) {
    order_by_instance(source, info, stack, options.allow_gaps);
    note(info, "slices are in the order of their InstanceNumber" + and_sides);
  } else if (options.order == SliceOrder::name) {
    order_by_name(stack);
    note(info, "slices are in the order of their names" + and_sides);
  } else if (std::any_of(stack.begin(), stack.end(),
                         [&](const DicomFrame& frame) { return frame.image != stack[0].image; })) {
    fail(source,
         "the " + std::to_string(stack.size()) +
             " slices have no place (ImagePositionPatient and ImageOrientationPatient), and so no "
             "order",
         "order them with --order instance (InstanceNumber) or --order name");
  } else if (stack.size() > 1) {
    note(info,
         "the frames have no place (ImagePositionPatient and ImageOrientationPatient), and are "
         "read in their order" +
             and_sides);
  }
}

// Whether two frames have one position.
bool have_one_place(const Frames& stack) {
  std::set<Vector> positions;
  for (const DicomFrame& frame : stack)
    if (frame.place && !positions.insert(frame.place->position).second) return true;
  return false;
}

// ---- the volume ----

void set_values(VolumeInfo& info, const Path& source, const Frames& stack) {
  // Throws if any scale is unusable.
  for (const DicomFrame& frame : stack) set_scale(info, source, frame.slope, frame.intercept);
  info.type = stack[0].image->type;
  // CT values without an intercept may have any unit.
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
  note(info, "slope and intercept differ between slices, so the values are converted to f32");
}

}  // namespace

void require_one_spacing(const Path& source, const Frames& stack) {
  constexpr double tolerance = 1e-4;
  for (const DicomFrame& frame : stack)
    for (std::size_t i = 0; i < 2; ++i) {
      const double first = stack[0].spacing_mm[i];
      if (std::fabs(frame.spacing_mm[i] - first) > tolerance * std::fabs(first))
        fail(source,
             "voxels are " + short_number(first) + " mm apart in " + name_of(stack[0]) + " and " +
                 short_number(frame.spacing_mm[i]) + " mm in " + name_of(frame),
             "resample the slices to one voxel size");
    }
}

void set_slice_line(VolumeInfo& info, const DicomFrame& first, const std::optional<SliceLine>& line,
                    const VolumeOptions& options) {
  const double distance = line ? length(line->step) : std::fabs(first.slice_spacing_mm);
  const std::string name = first.spacing_name == nullptr ? "" : first.spacing_name;
  if (!options.spacing_mm) {
    if (name.empty())
      note(info, "no PixelSpacing, 1 mm assumed");
    else if (name != "PixelSpacing")
      note(info, "no PixelSpacing, " + name + " is used" +
                     (name == "ImagerPixelSpacing" ? ", the spacing at the detector"
                      : name == "PixelAspectRatio" ? ", and 1 mm assumed along a row"
                                                   : ""));
    if (distance == 0) note(info, "no SpacingBetweenSlices or SliceThickness, 1 mm assumed");
  }
  const auto or_one = [](double length) { return length == 0 ? 1 : length; };
  DeclaredPlace place;
  place.set_unit("mm");
  place.spacing = {or_one(first.spacing_mm[0]), or_one(first.spacing_mm[1]), or_one(distance)};
  if (line) {
    place.space = first.place->is_of_patient ? Space::lps : Space::scanner;
    place.origin = line->origin;
    const Vector across =
        distance == 0 ? normal_of(*first.place) : sum({}, 1 / distance, line->step);
    place.directions = {first.place->along_row, first.place->along_column, across};
  }
  set_place(info, place, options);
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
    if (have_one_place(stack))
      note(info, "several slices have one position, and are read one behind the other");
  }
  require_one_spacing(source, stack);
  const DicomImage& image = *stack[0].image;
  for (const DicomFrame& frame : stack)
    if (frame.image->is_inverted != image.is_inverted)
      fail(source,
           "some slices are MONOCHROME1 and others MONOCHROME2: " + name_of(stack[0]) + " and " +
               name_of(frame),
           "give a pattern of those that are alike, or export the series again");
  if (!line && stack.size() > 1 && stack[0].slice_spacing_mm != 0 && !options.spacing_mm)
    note(info, "the slices are assumed to be " +
                   short_number(std::fabs(stack[0].slice_spacing_mm)) + " mm apart, by " +
                   stack[0].slice_spacing_name);
  set_dims(info, source, {image.columns, image.rows, static_cast<std::int64_t>(stack.size())});
  set_values(info, source, stack);
  set_slice_line(info, stack[0], line, options);
  for (const DicomFrame& frame : stack)
    for (const std::string& each : frame.image->notes) note(info, each);
  if (image.is_inverted)
    note(info, "MONOCHROME1: low values are bright; the values are used as stored");
  info.format = "DICOM";
  if (!image.compression.empty()) info.format += ", " + image.compression;
}

}  // namespace discmc::command
