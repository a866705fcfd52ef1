#include "segmentation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "order.hpp"
#include "pixels.hpp"
#include "stack.hpp"
#include "text/number_text.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

using Frames = std::vector<DicomFrame>;
using Path = std::filesystem::path;
/// The frames of each slice of the volume.
using Slices = std::vector<std::vector<const DicomFrame*>>;

const DicomSegments& segments_in(const Frames& frames) {
  return *frames[0].image->segments;
}

bool is_of_numbers(const Frames& frames) {
  return segments_in(frames).kind == DicomSegments::Kind::numbers;
}

// Reads the voxels of a frame as labels: the number of its segment.
class Labels {
 public:
  explicit Labels(const DicomImage& image)
      : count_(std::size_t{image.columns} * image.rows),
        stored_(count_ * sample_bytes(image.type)),
        is_on_(count_) {}

  /// Returns voxels, not 0 where the segment is. Valid until the next call.
  const std::uint8_t* read_segment(const DicomFrame& frame) {
    pixels_.read(frame, stored_.data());
    const std::uint32_t full = frame.image->segments->full;
    with_sample_type(frame.image->type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const sample = reinterpret_cast<const Sample*>(stored_.data());
      for (std::size_t i = 0; i < count_; ++i)
        is_on_[i] = sample[i] > 0 && 2 * static_cast<double>(sample[i]) >= full;
    });
    return is_on_.data();
  }

  /// Reads the numbers of all segments as stored.
  void read_numbers(const DicomFrame& frame, void* samples) { pixels_.read(frame, samples); }

 private:
  std::size_t count_;
  DicomPixels pixels_;
  std::vector<std::uint8_t> stored_;
  std::vector<std::uint8_t> is_on_;
};

class SegmentationVolume final : public NumberedSlices {
 public:
  SegmentationVolume(Path source, VolumeInfo info, Frames frames, Slices slices)
      : NumberedSlices(std::move(source), std::move(info)),
        frames_(std::move(frames)),
        slices_(std::move(slices)),
        labels_(*frames_[0].image) {}

 private:
  void read(std::uint32_t slice, void* samples) override {
    auto* const bytes = static_cast<unsigned char*>(samples);
    std::fill(bytes, bytes + info().slice_bytes(), static_cast<unsigned char>(0));
    for (const DicomFrame* frame : slices_[slice])
      if (is_of_numbers(frames_))
        labels_.read_numbers(*frame, samples);
      else if (info().type == SampleType::u8)
        paint(*frame, static_cast<std::uint8_t*>(samples));
      else
        paint(*frame, static_cast<std::uint16_t*>(samples));
  }

  template <class Label>
  void paint(const DicomFrame& frame, Label* labels) {
    const std::uint8_t* const is_on = labels_.read_segment(frame);
    const std::size_t count = std::size_t{info().dims[0]} * info().dims[1];
    for (std::size_t i = 0; i < count; ++i)
      if (is_on[i] != 0) labels[i] = static_cast<Label>(frame.segment);
  }

  Frames frames_;
  Slices slices_;  ///< frames of each slice
  Labels labels_;
};

// ---- positions of slices ----

std::vector<double> places_along(const Frames& frames, const Vector& normal) {
  constexpr double same_mm = 1e-3;
  std::vector<double> places;
  for (const DicomFrame& frame : frames) places.push_back(dot(frame.place->position, normal));
  std::sort(places.begin(), places.end());
  const auto is_same = [](double a, double b) { return b - a <= same_mm; };
  places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
  return places;
}

bool have_neighbours(const EvenSlices& slices) {
  return std::adjacent_find(slices.numbers.begin(), slices.numbers.end(),
                            [](std::uint64_t a, std::uint64_t b) { return b == a + 1; }) !=
         slices.numbers.end();
}

// Slices without a segment may be absent, so distances alone do not define the step.
EvenSlices even_slices(const Path& source, VolumeInfo& info, const DicomFrame& first,
                       const std::vector<double>& places) {
  const double declared = std::fabs(first.slice_spacing_mm);
  if (places.size() == 1) return {places[0], declared, {0}};
  const std::string name = declared > 0 ? first.slice_spacing_name : "";
  const std::string by_name = short_number(declared) + " mm of " + name;
  double min_distance = places[1] - places[0];
  for (std::size_t i = 1; i < places.size(); ++i)
    min_distance = std::min(min_distance, places[i] - places[i - 1]);
  constexpr double max_jitter = 0.1;  // of a step, as in images
  const double steps[] = {declared, min_distance, best_step(places)};
  for (const double share : {same_distance, max_jitter})
    for (const double step : steps) {
      const double rounding = std::max(half_a_decimal(places), share * step);
      const auto slices = slices_by_step(places, step, rounding);
      if (!slices) continue;
      if (!have_neighbours(*slices)) {
        if (name != "SpacingBetweenSlices") continue;
        note(info,
             "no two slices are the " + by_name + " apart: those between are assumed to be empty");
      } else if (declared > 0 && std::fabs(step - declared) > max_jitter * declared) {
        note(info, "the slices are " + short_number(step) + " mm apart, not the " + by_name);
      }
      if (share > same_distance)
        note(info, "slices lie up to " + short_number(farthest_off(places, *slices)) +
                       " mm from their place at even distances");
      return *slices;
    }
  fail(source,
       "the slices of the segmentation are " +
           short_number(declared > 0 ? declared : min_distance) + " mm apart, but not everywhere",
       "resample it to even distances, e.g. with 3D Slicer");
}

struct Grid {
  Slices slices;
  SliceLine line;
};

Grid grid_of(const Path& source, VolumeInfo& info, const Frames& frames) {
  constexpr std::uint64_t max_extent = 65536;
  const DicomFrame& first = frames[0];
  for (const DicomFrame& frame : frames)
    if (!frame.place || !have_one_direction(first, frame))
      fail(source, "a segmentation whose frames have no position, or are not parallel",
           "give the segmentation of a volume, not of a slide or a single picture");
  const Vector normal = normal_of(*first.place);
  const auto places = places_along(frames, normal);
  require_one_spacing(source, frames);
  const EvenSlices even = even_slices(source, info, first, places);
  const std::uint64_t count = even.numbers.back() + 1;
  if (count > max_extent)
    fail(source, "a segmentation of " + std::to_string(count) + " slices, most of them empty",
         "export it again");
  Grid grid{Slices(count), {}};
  Frames frame_at(places.size(), first);
  for (const DicomFrame& frame : frames) {
    const double along = dot(frame.place->position, normal);
    const auto place = static_cast<std::size_t>(
        std::upper_bound(places.begin(), places.end(), along) - 1 - places.begin());
    grid.slices[even.numbers[place]].push_back(&frame);
    frame_at[place] = frame;
  }
  const Vector& lowest = frame_at[0].place->position;
  grid.line = {sum(lowest, even.first - dot(lowest, normal), normal),
               slice_step(source, info, frame_at, even)};
  return grid;
}

// ---- segments ----

std::set<std::uint32_t> numbers_of(const Frames& frames) {
  std::set<std::uint32_t> numbers;
  for (const auto& [number, segment] : segments_in(frames).all) numbers.insert(number);
  if (!is_of_numbers(frames))
    for (const DicomFrame& frame : frames) numbers.insert(frame.segment);
  return numbers;
}

using Layers = std::map<std::uint32_t, std::uint32_t>;  // by segment

Layers layers_of(const Path& source, const Frames& frames, const Slices& slices) {
  Overlaps overlaps;
  if (!is_of_numbers(frames)) {
    const DicomImage& image = *frames[0].image;
    Labels labels(image);
    for (const auto& slice : slices) {
      if (slice.size() < 2) continue;
      overlaps.start_slice(std::size_t{image.columns} * image.rows);
      try {
        for (const DicomFrame* frame : slice)
          overlaps.add(frame->segment, labels.read_segment(*frame));
      } catch (const std::length_error& error) {
        fail(source, error.what(), "store the segments as files of their own");
      }
    }
  }
  return overlaps.layers(numbers_of(frames));
}

std::uint32_t count_of(const Layers& layers) {
  std::uint32_t count = 1;
  for (const auto& [segment, layer] : layers) count = std::max(count, layer + 1);
  return count;
}

LabelTable table_of(const DicomSegments& segments, const Layers& layers) {
  LabelTable table;
  for (const auto& [number, segment] : segments.all)
    if (!segment.name.empty())
      table.push_back({segment.name, segment.colour, {number}, layers.at(number)});
  return table;
}

void require_one_frame_a_segment(const Path& source, const Slices& slices) {
  for (const auto& slice : slices) {
    std::set<std::uint32_t> segments;
    for (const DicomFrame* frame : slice)
      if (!segments.insert(frame->segment).second)
        fail(
            source,
            "two frames have the same place and segment: " + name_of(*frame) + " and one before it",
            "export the segmentation again");
  }
}

}  // namespace

std::unique_ptr<VolumeReader> open_segmentation(const Path& source, const Frames& given,
                                                VolumeInfo info, const VolumeOptions& options) {
  Frames frames = given;
  const DicomSegments& segments = segments_in(frames);
  Grid grid = grid_of(source, info, frames);
  require_one_frame_a_segment(source, grid.slices);
  const Layers layers = layers_of(source, frames, grid.slices);

  const DicomImage& image = *frames[0].image;
  const std::uint32_t highest = layers.empty() ? 0 : layers.rbegin()->first;
  info.type = is_of_numbers(frames) ? image.type
              : highest <= 255      ? SampleType::u8
                                    : SampleType::u16;
  std::vector<std::int64_t> sizes = {image.columns, image.rows,
                                     static_cast<std::int64_t>(grid.slices.size())};
  if (const std::uint32_t count = count_of(layers); count > 1) sizes.push_back(count);
  set_dims(info, source, sizes, options.frame);
  const std::uint32_t layer = options.frame.value_or(0);
  for (auto& slice : grid.slices)
    slice.erase(std::remove_if(slice.begin(), slice.end(),
                               [&](const DicomFrame* frame) {
                                 return !is_of_numbers(frames) &&
                                        layers.at(frame->segment) != layer;
                               }),
                slice.end());
  set_slice_line(info, frames[0], grid.line, options);
  info.labels = table_of(segments, layers);
  if (segments.kind == DicomSegments::Kind::fractions)
    note(info, "fractional segments: a voxel belongs to a segment from a half on");
  for (const std::string& each : image.notes) note(info, each);
  info.format = "DICOM segmentation";
  if (!image.compression.empty()) info.format += ", " + image.compression;
  return std::make_unique<SegmentationVolume>(source, std::move(info), std::move(frames),
                                              std::move(grid.slices));
}

}  // namespace discmc::command
