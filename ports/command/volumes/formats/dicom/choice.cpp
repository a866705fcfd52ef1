#include "stack.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// Returns the whole UID, to be copied, without characters that no UID has.
std::string shown_uid(const std::string& uid) {
  constexpr std::size_t max_characters = 64;
  std::string text;
  for (const char c : uid.substr(0, max_characters))
    if ((c >= '0' && c <= '9') || c == '.') text += c;
  return text;
}

std::string count_of(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string description(const DicomStack& stack) {
  const DicomImage& image = stack.image();
  std::string text = count_of(stack.frames.size(), image.segments ? "frame" : "slice") + " of " +
                     std::to_string(image.columns) + " x " + std::to_string(image.rows);
  if (!stack.frames[0].place) text += " without position";
  if (!image.modality.empty()) text += ", " + shown(image.modality);
  if (!image.description.empty()) text += ", " + shown(image.description);
  if (image.segments) text += ", " + count_of(image.segments->all.size(), "segment");
  text += stack.distinction;
  if (!stack.order.empty()) text += ", " + stack.order;
  return text + ", UID " + shown_uid(image.series);
}

using Stacks = std::vector<DicomStack>;
using Places = std::vector<std::size_t>;

// Returns the end of a message. places: indexes of the stacks to list, from 0.
std::string list(const Stacks& stacks, const Places& places) {
  constexpr std::size_t max_shown = 50;
  std::string text = ":";
  for (std::size_t i = 0; i < std::min(places.size(), max_shown); ++i)
    text += "\n  " + std::to_string(places[i] + 1) + ": " + description(stacks[places[i]]);
  if (places.size() > max_shown)
    text += "\n  and " + std::to_string(places.size() - max_shown) + " more";
  return text;
}

bool have_one_series(const Stacks& stacks, const Places& places) {
  return std::all_of(places.begin(), places.end(), [&](std::size_t place) {
    return stacks[place].image().series == stacks[places[0]].image().series;
  });
}

// Returns how the volumes of one series differ.
std::string differences(const Stacks& stacks, const Places& places) {
  const auto frame = [&](std::size_t place) -> const DicomFrame& {
    return stacks[place].frames[0];
  };
  // Directions are compared with the first frame that has a direction.
  const auto placed = std::find_if(places.begin(), places.end(), [&](std::size_t place) {
    return frame(place).place.has_value();
  });
  const auto differ = [&](auto are_alike, std::size_t first) {
    return std::any_of(places.begin(), places.end(),
                       [&](std::size_t place) { return !are_alike(frame(first), frame(place)); });
  };
  std::string text;
  if (differ(
          [](const DicomFrame& a, const DicomFrame& b) {
            return a.image->columns == b.image->columns && a.image->rows == b.image->rows;
          },
          places[0]))
    text += ", of different extents";
  if (differ(
          [](const DicomFrame& a, const DicomFrame& b) { return a.image->type == b.image->type; },
          places[0]))
    text += ", of different types of samples";
  if (placed != places.end() &&
      differ([](const DicomFrame& a,
                const DicomFrame& b) { return !b.place || have_one_direction(a, b); },
             *placed))
    text += ", of different directions";
  if (differ([](const DicomFrame& a,
                const DicomFrame& b) { return a.place.has_value() == b.place.has_value(); },
             places[0]))
    text += ", with and without position (ImagePositionPatient and ImageOrientationPatient)";
  return text;
}

// Whether all are single slices of one size in series of their own, as some programs write them.
bool are_slices_of_series(const Stacks& stacks, const Places& places) {
  return std::all_of(places.begin(), places.end(), [&](std::size_t place) {
    const DicomImage& image = stacks[place].image();
    const DicomImage& first = stacks[places[0]].image();
    return stacks[place].frames.size() == 1 && image.columns == first.columns &&
           image.rows == first.rows && image.type == first.type;
  });
}

// Whether the stacks continue each other along one normal, for example if the slice distance
// changes.
bool are_consecutive(const Stacks& stacks, const Places& places) {
  std::vector<std::pair<double, double>> extents;
  for (const std::size_t place : places) {
    const DicomFrame& first = stacks[places[0]].frames[0];
    if (!first.place || !have_one_direction(first, stacks[place].frames[0])) return false;
    extents.push_back(extent_along(stacks[place], normal_of(*first.place)));
  }
  std::sort(extents.begin(), extents.end());
  return std::is_sorted(extents.begin(), extents.end(), [](const auto& a, const auto& b) {
    return a.first < b.second;  // whether b begins before a ends
  });
}

// Whether the slices all have the default position.
bool have_one_position(const Stacks& stacks, const Places& places) {
  const auto& first = stacks[places[0]].frames[0].place;
  return are_slices_of_series(stacks, places) &&
         std::all_of(places.begin(), places.end(), [&](std::size_t place) {
           const auto& other = stacks[place].frames[0].place;
           return first && other && other->position == first->position;
         });
}

[[noreturn]] void fail_several(const std::filesystem::path& source, const Stacks& stacks,
                               const Places& places) {
  const std::string choose = "choose one with --series N, its number in this list";
  if (have_one_series(stacks, places))
    fail(source, "several volumes in one series" + differences(stacks, places),
         choose +
             (have_one_position(stacks, places) ? ", or read them as slices with --order instance"
              : are_consecutive(stacks, places)
                  ? ", or resample all to one distance of slices, e.g. in 3D Slicer"
                  : "") +
             list(stacks, places));
  const std::string merge = are_slices_of_series(stacks, places)
                                ? ", or read them as slices of one volume with --merge-series"
                                : "";
  fail(source, "several volumes", choose + ", or --series UID" + merge + list(stacks, places));
}

Places chosen_places(const Stacks& stacks, const std::string& series) {
  const bool is_number = !series.empty() && series.size() < 6 &&
                         series.find_first_not_of("0123456789") == std::string::npos;
  Places chosen;
  for (std::size_t i = 0; i < stacks.size(); ++i)
    if (series.empty() || series == stacks[i].image().series ||
        (is_number && series == std::to_string(i + 1)))
      chosen.push_back(i);
  return chosen;
}

}  // namespace

ChosenStack chosen_stack(const std::filesystem::path& source, const Stacks& stacks,
                         const VolumeOptions& options) {
  const Places chosen = chosen_places(stacks, options.series);
  if (chosen.empty()) {
    Places all;
    for (std::size_t i = 0; i < stacks.size(); ++i) all.push_back(i);
    fail(source, "no series " + shown(options.series),
         "give one of these with --series" + list(stacks, all));
  }
  if (chosen.size() == 1) return {&stacks[chosen[0]]};
  if (!options.frame || !have_one_series(stacks, chosen)) fail_several(source, stacks, chosen);
  if (*options.frame >= chosen.size())
    fail(source, "there is no volume " + std::to_string(*options.frame),
         "choose one with --frame 0 to " + std::to_string(chosen.size() - 1) +
             ", in the order of this list" + list(stacks, chosen));
  return {&stacks[chosen[*options.frame]], chosen.size()};
}

}  // namespace discmc::command
