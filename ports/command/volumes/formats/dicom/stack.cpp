#include "stack.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <numeric>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>

#include "volumes/gaps.hpp"
#include "volumes/told_place.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::string number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::string name(const DicomFrame& frame) {
  std::string text = frame.image->file.filename().string();
  if (frame.number > 0) text += " frame " + std::to_string(frame.number);
  return text;
}

// ---- stacks of many frames ----

bool have_one_direction(const DicomFrame& a, const DicomFrame& b) {
  constexpr double along = 1 - 1e-6;  // a twelfth of a degree
  if (!a.place || !b.place) return !a.place && !b.place;
  return dot(a.place->along_row, b.place->along_row) > along &&
         dot(a.place->along_column, b.place->along_column) > along;
}

bool are_of_one_stack(const DicomFrame& a, const DicomFrame& b) {
  const auto kind = [](const DicomImage& image) {
    return std::tie(image.series, image.columns, image.rows, image.type);
  };
  return kind(*a.image) == kind(*b.image) && have_one_direction(a, b);
}

// Whole, to be copied: without what is of no UID.
std::string shown_uid(const std::string& uid) {
  constexpr std::size_t most = 64;
  std::string text;
  for (const char c : uid.substr(0, most))
    if ((c >= '0' && c <= '9') || c == '.') text += c;
  return text;
}

std::string description(const DicomStack& stack) {
  const DicomImage& image = *stack[0].image;
  std::string text = std::to_string(stack.size()) + (stack.size() == 1 ? " slice" : " slices") +
                     " of " + std::to_string(image.columns) + " x " + std::to_string(image.rows);
  if (!stack[0].place) text += " without position";
  if (!image.modality.empty()) text += ", " + shown(image.modality);
  if (!image.description.empty()) text += ", " + shown(image.description);
  return text + ", UID " + shown_uid(image.series);
}

using Places = std::vector<std::size_t>;

// places: of those to show among the stacks, the first is 0.
std::string list(const std::vector<DicomStack>& stacks, const Places& places) {
  constexpr std::size_t max_shown = 50;
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), max_shown); ++i)
    text += "\n  " + std::to_string(places[i] + 1) + ": " + description(stacks[places[i]]);
  if (places.size() > max_shown)
    text += "\n  and " + std::to_string(places.size() - max_shown) + " more";
  return text + "\n";
}

bool have_one_series(const std::vector<DicomStack>& stacks, const Places& places) {
  return std::all_of(places.begin(), places.end(), [&](std::size_t place) {
    return stacks[place][0].image->series == stacks[places[0]][0].image->series;
  });
}

// What makes volumes of one series several.
std::string differences(const std::vector<DicomStack>& stacks, const Places& places) {
  const auto differ = [&](auto are_alike) {
    return std::any_of(places.begin(), places.end(), [&](std::size_t a) {
      return std::any_of(places.begin(), places.end(),
                         [&](std::size_t b) { return !are_alike(stacks[a][0], stacks[b][0]); });
    });
  };
  std::string text;
  if (differ([](const DicomFrame& a, const DicomFrame& b) {
        return a.image->columns == b.image->columns && a.image->rows == b.image->rows;
      }))
    text += ", of different extents";
  if (differ(
          [](const DicomFrame& a, const DicomFrame& b) { return a.image->type == b.image->type; }))
    text += ", of different types of samples";
  if (differ([](const DicomFrame& a, const DicomFrame& b) {
        return !a.place || !b.place || have_one_direction(a, b);
      }))
    text += ", of different directions";
  if (differ([](const DicomFrame& a, const DicomFrame& b) {
        return a.place.has_value() == b.place.has_value();
      }))
    text += ", with and without position (ImagePositionPatient and ImageOrientationPatient)";
  return text;
}

// ---- the order of a stack ----

// How far a frame lies along the normal of the stack. Units: millimetres.
class Along {
 public:
  explicit Along(const DicomFrame& first) : normal_(normal_of(*first.place)) {}
  double operator()(const DicomFrame& frame) const { return dot(frame.place->position, normal_); }

 private:
  Vector normal_;
};

// Drops frames that are there twice. Returns how many.
std::size_t drop_duplicates(const std::filesystem::path& source, DicomStack& stack,
                            const Along& along, const SamePixels& same_pixels) {
  constexpr double same_mm = 1e-5;
  DicomStack kept;
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
           "two slices at " + number(along(frame)) + " mm differ: " + name(kept.back()) + " and " +
               name(frame) + ", as of several times or echoes",
           "give a folder with the files of one of them");
  }
  const std::size_t dropped = stack.size() - kept.size();
  stack = std::move(kept);
  return dropped;
}

// How far slices are from each other, and where some are missing.
struct Distances {
  double step = 0;
  std::vector<Gap> gaps;
};

// Throws unless the slices are as far from each other everywhere, but for gaps.
Distances even_distances(const std::filesystem::path& source, const DicomStack& stack,
                         const Along& along) {
  constexpr double tolerance = 0.02;  // of the distance: positions are rounded decimals
  std::vector<double> steps;
  for (std::size_t i = 1; i < stack.size(); ++i)
    steps.push_back(along(stack[i]) - along(stack[i - 1]));
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const auto is_even = [median = *middle](double distance) {
    return std::fabs(distance - median) <= tolerance * median;
  };
  // The mean of them, as what is rounded adds up over a gap.
  const auto odd = std::partition(sorted.begin(), sorted.end(), is_even);
  const double step = std::accumulate(sorted.begin(), odd, 0.0) /
                      static_cast<double>(std::distance(sorted.begin(), odd));
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (is_even(steps[i])) continue;
    const double missing =
        std::min(std::round(steps[i] / step) - 1, static_cast<double>(max_missing));
    const std::string where = "between " + number(along(stack[i])) + " mm (" + name(stack[i]) +
                              ") and " + number(along(stack[i + 1])) + " mm (" +
                              name(stack[i + 1]) + ")";
    if (!(missing >= 1 && std::fabs(steps[i] - (missing + 1) * step) <= tolerance * step))
      fail(source,
           "the slices are " + number(step) + " mm apart, but " + number(steps[i]) + " mm " + where,
           "resample the series to even distances, e.g. with 3D Slicer or dcm2niix");
    gaps.push_back({i, static_cast<std::uint64_t>(missing),
                    where + ", where the others are " + number(step) + " mm apart"});
  }
  const std::uint64_t all_steps = steps.size() + missing_slices(gaps);
  return {(along(stack.back()) - along(stack.front())) / static_cast<double>(all_steps),
          std::move(gaps)};
}

// Throws where the slices do not lie straight above each other.
void require_straight(const std::filesystem::path& source, const DicomStack& stack,
                      const Along& along) {
  const DicomPlace& first = *stack.front().place;
  const Vector normal = normal_of(first);
  const double most =
      0.5 * std::max({stack[0].spacing_mm[0], stack[0].spacing_mm[1], 1e-3});  // half a voxel
  for (const DicomFrame& frame : stack) {
    const double way = along(frame) - along(stack.front());
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double aside = frame.place->position[i] - first.position[i] - way * normal[i];
      square += aside * aside;
    }
    if (std::sqrt(square) > most)
      fail(source,
           name(frame) + " is shifted aside by " + number(std::sqrt(square)) + " mm against " +
               name(stack.front()) + ", as with a tilted gantry",
           "resample the series to a straight one, e.g. with dcm2niix");
  }
}

double distance_by_places(const std::filesystem::path& source, VolumeInfo& info, DicomStack& stack,
                          const SamePixels& same_pixels, bool allow_gaps) {
  const Along along(stack[0]);
  std::stable_sort(stack.begin(), stack.end(),
                   [&](const DicomFrame& a, const DicomFrame& b) { return along(a) < along(b); });
  if (const std::size_t dropped = drop_duplicates(source, stack, along, same_pixels); dropped > 0)
    note(info, std::to_string(dropped) + (dropped == 1 ? " slice that is there twice dropped"
                                                       : " slices that are there twice dropped"));
  if (stack.size() == 1) return stack[0].slice_spacing_mm;
  require_straight(source, stack, along);
  const Distances distances = even_distances(source, stack, along);
  if (!distances.gaps.empty()) {
    note(info, note_of_filling(source, distances.gaps, stack.size(), allow_gaps,
                               "export or copy the series again"));
    fill_gaps(stack, distances.gaps);
  }
  return distances.step;
}

double distance_without_places(const std::filesystem::path& source, VolumeInfo& info,
                               const DicomStack& stack) {
  for (const DicomFrame& frame : stack)
    if (frame.image != stack[0].image)
      fail(source,
           "the " + std::to_string(stack.size()) +
               " slices tell no position (ImagePositionPatient), and so no order",
           "export the series with positions, or as a stack of PNG or TIFF files");
  if (stack.size() > 1) note(info, "the frames tell no positions, taken in their order");
  return stack[0].slice_spacing_mm;
}

// ---- the volume ----

void require_one_spacing(const std::filesystem::path& source, const DicomStack& stack) {
  constexpr double tolerance = 1e-4;
  for (const DicomFrame& frame : stack)
    for (std::size_t i = 0; i < 2; ++i) {
      const double first = stack[0].spacing_mm[i];
      if (std::fabs(frame.spacing_mm[i] - first) > tolerance * std::fabs(first))
        fail(source,
             "voxels are " + number(first) + " mm apart in " + name(stack[0]) + " and " +
                 number(frame.spacing_mm[i]) + " mm in " + name(frame),
             "resample the slices to one size of voxels");
    }
}

void set_values(VolumeInfo& info, const std::filesystem::path& source, const DicomStack& stack) {
  // Throws where one is of no use.
  for (const DicomFrame& frame : stack) set_scale(info, source, frame.slope, frame.intercept);
  info.type = stack[0].image->type;
  // The values of CT that are not shifted may be of any unit.
  info.is_in_hounsfield = stack[0].image->modality == "CT" && info.intercept < 0;
  if (have_one_scale(stack)) return;
  info.type = SampleType::f32;
  info.slope = 1;
  info.intercept = 0;
  note(info, "slope and intercept differ from slice to slice, values taken as f32");
}

ToldPlace place_of(const DicomFrame& first, double distance_mm) {
  ToldPlace told;
  told.set_unit("mm");
  told.spacing = {first.spacing_mm[0], first.spacing_mm[1], distance_mm};
  if (!first.place) return told;
  told.frame = Frame::lps;
  told.origin = first.place->position;
  told.directions = {first.place->along_row, first.place->along_column, normal_of(*first.place)};
  return told;
}

}  // namespace

bool have_one_scale(const DicomStack& stack) {
  return std::all_of(stack.begin(), stack.end(), [&](const DicomFrame& frame) {
    return frame.slope == stack[0].slope && frame.intercept == stack[0].intercept;
  });
}

std::vector<DicomStack> dicom_stacks(const std::vector<DicomFrame>& frames) {
  std::vector<DicomStack> stacks;
  for (const DicomFrame& frame : frames) {
    const auto stack = std::find_if(stacks.begin(), stacks.end(), [&](const DicomStack& known) {
      return are_of_one_stack(known[0], frame);
    });
    if (stack != stacks.end())
      stack->push_back(frame);
    else
      stacks.push_back({frame});
  }
  std::stable_sort(stacks.begin(), stacks.end(), [](const DicomStack& a, const DicomStack& b) {
    const auto key = [](const DicomStack& stack) {
      return std::tie(stack[0].image->series_number, stack[0].image->series);
    };
    return key(a) < key(b);
  });
  return stacks;
}

const DicomStack& chosen_stack(const std::filesystem::path& source,
                               const std::vector<DicomStack>& stacks, const std::string& series) {
  const bool is_number = !series.empty() && series.size() < 6 &&
                         series.find_first_not_of("0123456789") == std::string::npos;
  Places all, chosen;
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    all.push_back(i);
    if (series.empty() || series == stacks[i][0].image->series ||
        (is_number && series == std::to_string(i + 1)))
      chosen.push_back(i);
  }
  if (chosen.size() == 1) return stacks[chosen[0]];
  if (chosen.empty())
    fail(source, "no series " + shown(series) + " among" + list(stacks, all),
         "give one of them to --series");
  if (have_one_series(stacks, chosen))
    fail(source,
         "several volumes in one series" + differences(stacks, chosen) + ":" + list(stacks, chosen),
         "choose one with --series N, its number in this list");
  fail(source, "several volumes:" + list(stacks, chosen),
       "choose one with --series N, its number in this list, or --series UID");
}

VolumeInfo order_stack(const std::filesystem::path& source, DicomStack& stack,
                       const SamePixels& same_pixels, const VolumeOptions& options) {
  VolumeInfo info;
  const double distance =
      stack[0].place ? distance_by_places(source, info, stack, same_pixels, options.allow_gaps)
                     : distance_without_places(source, info, stack);
  require_one_spacing(source, stack);
  const DicomImage& image = *stack[0].image;
  set_dims(info, source, {image.columns, image.rows, static_cast<std::int64_t>(stack.size())});
  set_values(info, source, stack);
  set_place(info, place_of(stack[0], distance), options);
  if (image.is_inverted)
    note(info, "MONOCHROME1: the low values are the bright ones, taken as stored");
  info.format = "DICOM";
  if (!image.compression.empty()) info.format += ", " + image.compression;
  return info;
}

}  // namespace discmc::command
