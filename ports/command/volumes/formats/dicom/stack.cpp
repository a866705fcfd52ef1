#include "stack.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>

#include "order.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

using Frames = std::vector<DicomFrame>;

// Returns what frames of one kind share, except their direction. Segmentations are never joined.
auto kind_of(const DicomFrame& frame, bool merges_series) {
  const DicomImage& image = *frame.image;
  return std::tuple(image.segments ? &image : nullptr, merges_series ? std::string() : image.series,
                    image.columns, image.rows, image.channels, image.type);
}

// The kinds are in the order of their first frames.
std::vector<Frames> by_kind(const Frames& frames, bool merges_series) {
  std::vector<Frames> groups;
  std::map<decltype(kind_of(frames[0], false)), std::vector<std::size_t>> places_by_kind;
  for (const DicomFrame& frame : frames) {
    std::vector<std::size_t>& places = places_by_kind[kind_of(frame, merges_series)];
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

// Whether there are more than two frames, and all differ in a trait.
bool are_all_different(const Frames& frames, std::size_t kind) {
  std::set<std::string> values;
  for (const DicomFrame& frame : frames) values.insert(trait_of(frame.traits, kind));
  return values.size() > 2 && values.size() == frames.size();
}

// Splits the frames by the traits of the requested kinds.
template <class IsAsked>
std::vector<Frames> by_traits(const Frames& frames, IsAsked is_asked) {
  std::vector<std::size_t> kinds;
  for (std::size_t kind = 0; kind < trait_count(); ++kind)
    if (is_asked(kind) && !(is_uid(kind) && are_all_different(frames, kind))) kinds.push_back(kind);
  std::map<std::vector<std::string>, Frames> groups;
  for (const DicomFrame& frame : frames) {
    std::vector<std::string> values;
    for (const std::size_t kind : kinds) values.push_back(trait_of(frame.traits, kind));
    groups[values].push_back(frame);
  }
  std::vector<Frames> result;
  result.reserve(groups.size());
  for (auto& [traits, group] : groups) result.push_back(std::move(group));
  return result;
}

// Whether the frames are evenly spaced on one line, each position once.
bool are_even(Frames frames) {
  if (frames.size() < 3 || !frames[0].place) return false;
  const Vector normal = normal_of(*frames[0].place);
  const auto along_of = [&](const DicomFrame& frame) { return dot(frame.place->position, normal); };
  std::sort(frames.begin(), frames.end(),
            [&](const DicomFrame& a, const DicomFrame& b) { return along_of(a) < along_of(b); });
  std::vector<double> along;
  for (const DicomFrame& frame : frames) {
    along.push_back(along_of(frame));
    const Vector offset = sum(frame.place->position, -1, frames[0].place->position);
    const Vector aside = sum(offset, -dot(offset, normal), normal);
    if (length(aside) > 0.1 * std::min(frame.spacing_mm[0], frame.spacing_mm[1])) return false;
  }
  OddDistance odd;
  const auto slices = slices_by_distances(along, same_distance, odd);
  return slices && slices->step > 0 && slices->numbers.back() == frames.size() - 1;
}

// Stacks acquired in turn may form one volume.
std::vector<Frames> by_stack(const Frames& frames) {
  auto groups = by_traits(frames, is_of_stack);
  if (groups.size() > 1 && are_even(frames)) return {frames};
  return groups;
}

// ---- what distinguishes stacks of one series ----

// Returns an empty string unless all frames share one value.
std::string common_trait(const Frames& frames, std::size_t kind) {
  const std::string& value = trait_of(frames[0].traits, kind);
  const bool is_common = std::all_of(frames.begin(), frames.end(), [&](const DicomFrame& frame) {
    return trait_of(frame.traits, kind) == value;
  });
  return is_common ? value : std::string();
}

using Siblings = std::vector<DicomStack*>;

// Returns the kinds of traits that distinguish the stacks, only readable ones if they suffice.
std::vector<std::size_t> distinguishing(const Siblings& stacks) {
  constexpr std::size_t max_listed = 3;
  std::vector<std::size_t> kinds;
  for (std::size_t kind = 0; kind < trait_count() && kinds.size() < max_listed; ++kind) {
    if (!kinds.empty() && is_for_programs(kind)) continue;
    std::set<std::string> values;
    for (const DicomStack* stack : stacks) values.insert(common_trait(stack->frames, kind));
    if (values.size() > 1) kinds.push_back(kind);
  }
  return kinds;
}

std::string vector_text(const Vector& vector) {
  std::string text;
  for (const double component : vector) text += ' ' + short_number(component + 0.0);  // no -0
  return text;
}

// Returns the positions of the slices along their normal.
std::string extent_of(const DicomStack& stack) {
  if (!stack.frames[0].place || stack.image().segments) return {};
  const auto [least, most] = extent_along(stack, normal_of(*stack.frames[0].place));
  return ", at " + short_number(least) + (least < most ? " to " + short_number(most) : "") + " mm";
}

std::string direction_of(const DicomStack& stack) {
  return stack.frames[0].place ? ", across" + vector_text(normal_of(*stack.frames[0].place)) : "";
}

template <class Text>
void distinguish_by(const Siblings& stacks, Text text) {
  std::set<std::string> texts;
  for (const DicomStack* stack : stacks) texts.insert(text(*stack));
  if (texts.size() < 2) return;
  for (DicomStack* stack : stacks) stack->distinction += text(*stack);
}

void distinguish(const Siblings& stacks) {
  if (stacks.size() < 2) return;
  for (const std::size_t kind : distinguishing(stacks))
    for (DicomStack* stack : stacks)
      if (const std::string value = common_trait(stack->frames, kind); !value.empty())
        stack->distinction += ", " + trait_text(kind, value);
  distinguish_by(stacks, direction_of);
  distinguish_by(stacks, extent_of);
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
  constexpr double along = 1 - 1e-6;  // cosine of a twelfth of a degree
  if (!a.place || !b.place) return !a.place && !b.place;
  return dot(a.place->along_row, b.place->along_row) > along &&
         dot(a.place->along_column, b.place->along_column) > along;
}

std::pair<double, double> extent_along(const DicomStack& stack, const Vector& normal) {
  std::vector<double> along;
  for (const DicomFrame& frame : stack.frames)
    along.push_back(dot(frame.place->position, normal) + 0.0);
  const auto [least, most] = std::minmax_element(along.begin(), along.end());
  return {*least, *most};
}

std::string name_of(const DicomFrame& frame) {
  std::string text = frame.image->file.filename().string();
  if (frame.number > 0) text += " frame " + std::to_string(frame.number);
  return text;
}

std::vector<DicomStack> dicom_stacks(const std::vector<DicomFrame>& frames,
                                     const DicomSorting& sorting) {
  std::vector<DicomStack> stacks;
  for (const Frames& frames_of_kind : by_kind(frames, sorting.merges_series))
    for (const Frames& alike : by_traits(frames_of_kind, is_of_volume))
      for (const Frames& stack : by_stack(alike))
        for (SeparatedFrames& volume : volumes_of(stack, sorting.is_by_position))
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
