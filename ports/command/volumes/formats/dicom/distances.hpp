// Even distances of slices, found in positions that are rounded and of which some may be missing.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_DISTANCES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_DISTANCES_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace discmc::command {

/// Slices one step from each other. Units: millimetres along the normal.
struct EvenSlices {
  double first = 0;  ///< where number 0 lies
  double step = 0;
  /// The number of every slice, from 0; an omitted number is a missing slice.
  std::vector<std::uint64_t> numbers;
};

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

#endif
