// Orders the slices of a DICOM volume, and finds their positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// The place of the first slice, and the step to the next one.
struct SliceLine {
  Vector origin{};
  Vector step{};
};

/// Whether two frames have the same pixels.
using SamePixels = std::function<bool(const DicomFrame&, const DicomFrame&)>;

/// Sets spacing and placement for slices of one kind, and notes missing items. Without a line, the
/// volume has no placement.
void set_slice_line(VolumeInfo& info, const DicomFrame& first, const std::optional<SliceLine>& line,
                    const VolumeOptions& options);

/// Throws VolumeError unless all frames have one voxel spacing.
void require_one_spacing(const std::filesystem::path& source, const std::vector<DicomFrame>& stack);

/// Whether all frames share one slope and intercept.
bool have_one_scale(const std::vector<DicomFrame>& stack);

/// Orders the frames by position, each position once, or as the options ask. Describes the volume
/// in the info. Throws VolumeError if slices are missing and gaps are not allowed, or if slices are
/// uneven or not on one line.
void order_stack(const std::filesystem::path& source, std::vector<DicomFrame>& stack,
                 const SamePixels& same_pixels, const VolumeOptions& options, VolumeInfo& info);

/// Orders frames with places by position, each position once, and fills gaps if allowed. Notes
/// assumptions. Throws VolumeError if slices are missing otherwise, or if slices are uneven or not
/// on one line.
SliceLine order_by_position(const std::filesystem::path& source, VolumeInfo& info,
                            std::vector<DicomFrame>& stack, const SamePixels& same_pixels,
                            bool allow_gaps);

/// Fills missing slice numbers, with a note, or refuses them. places: of each slice, for people.
void fill_missing(const std::filesystem::path& source, VolumeInfo& info,
                  std::vector<DicomFrame>& stack, const std::vector<std::uint64_t>& numbers,
                  const std::vector<std::string>& places, bool allow_gaps);

/// Evenly spaced slices. Units: millimetres along the normal.
struct EvenSlices {
  double first = 0;  ///< position of number 0
  double step = 0;
  /// The number of each slice, from 0; an unused number is a missing slice.
  std::vector<std::uint64_t> numbers;
};

/// Returns the step to the next slice: along the normal, or also sideways for a tilted gantry, with
/// a note. Throws VolumeError if the slices are not on one line.
Vector slice_step(const std::filesystem::path& source, VolumeInfo& info,
                  const std::vector<DicomFrame>& stack, const EvenSlices& slices);

/// Returns even slices with this step, each at most `rounding` away from its ideal position, or
/// nothing. along: position of each slice, ascending. Limit: at least one slice.
std::optional<EvenSlices> slices_by_step(const std::vector<double>& along, double step,
                                         double rounding);

/// Returns the step that minimises the largest deviation, assuming that no slice is missing.
double best_step(const std::vector<double>& along);

/// Returns the largest deviation of a slice from its ideal position.
double farthest_off(const std::vector<double>& along, const EvenSlices& slices);

/// Returns half of the last decimal place if all numbers are rounded to tenths, hundredths or
/// thousandths; otherwise 0.
double half_a_decimal(const std::vector<double>& numbers);

/// Distances that differ by at most this share are equal.
constexpr double same_distance = 0.02;

/// A distance that is not a multiple of the others.
struct OddDistance {
  double step = 0;
  std::size_t slice = 0;  ///< the slice before the distance
};

/// Returns even slices by their distances alone, each of which is a step, or several if slices are
/// missing. tolerance: as a share of the step. odd: the reason if there are none.
std::optional<EvenSlices> slices_by_distances(const std::vector<double>& along, double tolerance,
                                              OddDistance& odd);

}  // namespace discmc::command
