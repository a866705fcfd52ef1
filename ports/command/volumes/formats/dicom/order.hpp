// The slices of a DICOM volume in their order, and where they lie.
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

/// The place of a first slice, and the way to the next one.
struct SliceLine {
  Vector origin{};
  Vector step{};
};

/// Whether two frames have the same pixels.
using SamePixels = std::function<bool(const DicomFrame&, const DicomFrame&)>;

/// Takes spacing and placement of slices that are alike, with notes of what is missing. Without a
/// line they lie in no space.
void set_slice_line(VolumeInfo& info, const DicomFrame& first, const std::optional<SliceLine>& line,
                    const VolumeOptions& options);

/// Throws VolumeError unless the voxels of all frames are as far apart.
void require_one_spacing(const std::filesystem::path& source, const std::vector<DicomFrame>& stack);

/// Whether one slope and intercept is of all frames.
bool have_one_scale(const std::vector<DicomFrame>& stack);

/// Orders the frames by position, each position once, or as the options ask. Adds to the info what
/// volume they are. Throws VolumeError where slices are missing and gaps are not allowed, are not
/// as far from each other everywhere, or not on one line.
void order_stack(const std::filesystem::path& source, std::vector<DicomFrame>& stack,
                 const SamePixels& same_pixels, const VolumeOptions& options, VolumeInfo& info);

/// Puts frames with places in the order of these, each place once, and fills gaps if that is
/// allowed. Adds to the notes what was assumed. Throws VolumeError where slices are missing
/// otherwise, are not as far from each other everywhere, or not on one line.
SliceLine order_by_position(const std::filesystem::path& source, VolumeInfo& info,
                            std::vector<DicomFrame>& stack, const SamePixels& same_pixels,
                            bool allow_gaps);

/// Fills the places of slices whose numbers are left out, with a note, or refuses them.
/// places: of each slice, for people.
void fill_missing(const std::filesystem::path& source, VolumeInfo& info,
                  std::vector<DicomFrame>& stack, const std::vector<std::uint64_t>& numbers,
                  const std::vector<std::string>& places, bool allow_gaps);

/// Slices one step from each other. Units: millimetres along the normal.
struct EvenSlices {
  double first = 0;  ///< where number 0 lies
  double step = 0;
  /// The number of every slice, from 0; an omitted number is a missing slice.
  std::vector<std::uint64_t> numbers;
};

/// Returns the way to the next slice: along the normal, or aside, too, as with a tilted gantry;
/// then it is noted. Throws VolumeError where the slices are not on one line.
Vector slice_step(const std::filesystem::path& source, VolumeInfo& info,
                  const std::vector<DicomFrame>& stack, const EvenSlices& slices);

/// Returns even slices with a step, each not farther than `rounding` from where it should be;
/// nothing where there are none. along: of every slice, growing. Limit: one slice or more.
std::optional<EvenSlices> slices_by_step(const std::vector<double>& along, double step,
                                         double rounding);

/// The step with which no slice is far from where it should be, if none is missing.
double best_step(const std::vector<double>& along);

/// How far the farthest slice is from where it should be.
double farthest_off(const std::vector<double>& along, const EvenSlices& slices);

/// Half of the last decimal place of numbers that are all rounded to tenths, hundredths or
/// thousandths; otherwise 0.
double half_a_decimal(const std::vector<double>& numbers);

/// Distances that differ by this share of them are the same.
constexpr double same_distance = 0.02;

/// A distance that is no multiple of the others.
struct OddDistance {
  double step = 0;
  std::size_t slice = 0;  ///< the one before it
};

/// Returns even slices by their distances alone, each of which is a step, or several where slices
/// are missing. tolerance: as a share of it. odd: where there are none, why.
std::optional<EvenSlices> slices_by_distances(const std::vector<double>& along, double tolerance,
                                              OddDistance& odd);

}  // namespace discmc::command
