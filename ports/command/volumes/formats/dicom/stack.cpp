#include "stack.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "separation.hpp"
#include "vectors.hpp"

namespace discmc::command {
namespace {

using Frames = std::vector<DicomFrame>;

// What frames of one kind have in common, but for their direction. Segmentations are never joined.
auto kind_of(const DicomFrame& frame, bool merges_series) {
  const DicomImage& image = *frame.image;
  return std::tuple(image.segments ? &image : nullptr, merges_series ? std::string() : image.series,
                    image.columns, image.rows, image.type);
}

// In the order of their first frames.
std::vector<Frames> by_kind(const Frames& frames, bool merges_series) {
  std::vector<Frames> groups;
  std::map<decltype(kind_of(frames[0], false)), std::vector<std::size_t>> of_kind;
  for (const DicomFrame& frame : frames) {
    std::vector<std::size_t>& places = of_kind[kind_of(frame, merges_series)];
    const auto place = std::find_if(places.begin(), places.end(), [&](std::size_t each) {
      return frame.image->segments || have_one_direction(groups[each][0], frame);
    });
    if (place != places.end()) {
      groups[*place].push_back(frame);
    } else {
      places.push_back(groups.size());
      groups.push_back({frame});
    }
  }
  return groups;
}

// What frames of one volume have in common in any case.
std::vector<std::string> traits_of_volume(const DicomFrame& frame) {
  std::vector<std::string> values;
  for (std::size_t kind = 0; kind < trait_count(); ++kind)
    if (is_of_volume(kind)) values.push_back(trait_of(frame.traits, kind));
  return values;
}

std::vector<Frames> by_traits_of_volume(const Frames& frames) {
  std::map<std::vector<std::string>, Frames> groups;
  for (const DicomFrame& frame : frames) groups[traits_of_volume(frame)].push_back(frame);
  std::vector<Frames> result;
  result.reserve(groups.size());
  for (auto& [traits, group] : groups) result.push_back(std::move(group));
  return result;
}

// ---- what distinguishes stacks of one series ----

// Empty where the frames have not one value.
std::string common_trait(const Frames& frames, std::size_t kind) {
  const std::string& value = trait_of(frames[0].traits, kind);
  const bool is_common = std::all_of(frames.begin(), frames.end(), [&](const DicomFrame& frame) {
    return trait_of(frame.traits, kind) == value;
  });
  return is_common ? value : std::string();
}

using Siblings = std::vector<DicomStack*>;

// The kinds of traits in which the stacks differ, those for people only if they suffice.
std::vector<std::size_t> distinguishing(const Siblings& stacks) {
  constexpr std::size_t most = 3;
  std::vector<std::size_t> kinds;
  for (std::size_t kind = 0; kind < trait_count() && kinds.size() < most; ++kind) {
    if (!kinds.empty() && is_for_programs(kind)) break;
    std::set<std::string> values;
    for (const DicomStack* stack : stacks) values.insert(common_trait(stack->frames, kind));
    if (values.size() > 1) kinds.push_back(kind);
  }
  return kinds;
}

void distinguish(const Siblings& stacks) {
  if (stacks.size() < 2) return;
  for (const std::size_t kind : distinguishing(stacks))
    for (DicomStack* stack : stacks)
      if (const std::string value = common_trait(stack->frames, kind); !value.empty())
        stack->distinction += ", " + trait_text(kind, value);
}

void distinguish_all(std::vector<DicomStack>& stacks) {
  std::map<std::string, Siblings> series;
  for (DicomStack& stack : stacks) series[stack.image().series].push_back(&stack);
  for (const auto& [uid, siblings] : series) distinguish(siblings);
}

std::vector<SeparatedFrames> volumes_of(const Frames& frames, bool is_by_position) {
  const bool have_places = frames[0].place && !frames[0].image->segments;
  if (is_by_position && have_places) return separated(frames);
  return {{frames, {}}};
}

}  // namespace

bool have_one_direction(const DicomFrame& a, const DicomFrame& b) {
  constexpr double along = 1 - 1e-6;  // a twelfth of a degree
  if (!a.place || !b.place) return !a.place && !b.place;
  return dot(a.place->along_row, b.place->along_row) > along &&
         dot(a.place->along_column, b.place->along_column) > along;
}

std::string name_of(const DicomFrame& frame) {
  std::string text = frame.image->file.filename().string();
  if (frame.number > 0) text += " frame " + std::to_string(frame.number);
  return text;
}

std::vector<DicomStack> dicom_stacks(const std::vector<DicomFrame>& frames,
                                     const DicomSorting& sorting) {
  std::vector<DicomStack> stacks;
  for (const Frames& of_kind : by_kind(frames, sorting.merges_series))
    for (const Frames& alike : by_traits_of_volume(of_kind))
      for (SeparatedFrames& volume : volumes_of(alike, sorting.is_by_position))
        stacks.push_back({std::move(volume.frames), {}, std::move(volume.order)});
  std::stable_sort(stacks.begin(), stacks.end(), [](const DicomStack& a, const DicomStack& b) {
    const auto key = [](const DicomStack& stack) {
      return std::tie(stack.image().series_number, stack.image().series);
    };
    return key(a) < key(b);
  });
  distinguish_all(stacks);
  return stacks;
}

}  // namespace discmc::command
