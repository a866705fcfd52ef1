#include "order.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "volumes/gaps.hpp"

namespace discmc::command {
namespace {

constexpr double same_mm = 1e-6;  // rounding of sums of decimals

std::vector<double> distances_of(const std::vector<double>& along) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < along.size(); ++i) distances.push_back(along[i] - along[i - 1]);
  return distances;
}

struct Ends {
  double low = 0, high = 0;
};

// Returns the range of positions of number 0, by each of the slices.
Ends firsts(const std::vector<double>& along, const std::vector<std::uint64_t>& numbers,
            double step) {
  Ends ends{along[0], along[0]};
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double first = along[i] - static_cast<double>(numbers[i]) * step;
    ends.low = std::min(ends.low, first);
    ends.high = std::max(ends.high, first);
  }
  return ends;
}

}  // namespace

std::optional<EvenSlices> slices_by_step(const std::vector<double>& along, double step,
                                         double rounding) {
  constexpr double max_share = 0.25;  // of a step; beyond, a slice could be its neighbour
  if (!(step > 0) || rounding > max_share * step) return std::nullopt;
  EvenSlices slices{along[0], step, {0}};
  for (std::size_t i = 1; i < along.size(); ++i) {
    const double number = std::round((along[i] - along[0]) / step);
    if (!(number > static_cast<double>(slices.numbers.back()) && number <= max_missing))
      return std::nullopt;
    slices.numbers.push_back(static_cast<std::uint64_t>(number));
  }
  const Ends ends = firsts(along, slices.numbers, step);
  if (ends.high - ends.low > 2 * (rounding + same_mm)) return std::nullopt;
  // The stored position is preferred.
  if (farthest_off(along, slices) > rounding + same_mm) slices.first = (ends.low + ends.high) / 2;
  return slices;
}

double best_step(const std::vector<double>& along) {
  std::vector<std::uint64_t> numbers(along.size());
  std::iota(numbers.begin(), numbers.end(), std::uint64_t{0});
  const auto spread = [&](double step) {
    const Ends ends = firsts(along, numbers, step);
    return ends.high - ends.low;
  };
  // The function has one minimum between the smallest and the largest distance.
  const std::vector<double> distances = distances_of(along);
  const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
  double low = *least, high = *most;
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3;
    if (spread(low + third) > spread(high - third))
      low += third;
    else
      high -= third;
  }
  return (low + high) / 2;
}

double farthest_off(const std::vector<double>& along, const EvenSlices& slices) {
  double farthest = 0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double place = slices.first + static_cast<double>(slices.numbers[i]) * slices.step;
    farthest = std::max(farthest, std::fabs(along[i] - place));
  }
  return farthest;
}

double half_a_decimal(const std::vector<double>& numbers) {
  for (const double places : {10.0, 100.0, 1000.0})
    if (std::all_of(numbers.begin(), numbers.end(), [places](double number) {
          return std::fabs(number * places - std::round(number * places)) < same_mm * places;
        }))
      return 0.5 / places;
  return 0;
}

std::optional<EvenSlices> slices_by_distances(const std::vector<double>& along, double tolerance,
                                              OddDistance& odd) {
  const std::vector<double> steps = distances_of(along);
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const auto is_even = [median = *middle, tolerance](double distance) {
    return std::fabs(distance - median) <= tolerance * median;
  };
  // Takes the mean of even distances, because rounding adds up over a gap.
  const auto uneven = std::partition(sorted.begin(), sorted.end(), is_even);
  const double step = std::accumulate(sorted.begin(), uneven, 0.0) /
                      static_cast<double>(std::distance(sorted.begin(), uneven));
  EvenSlices slices{along[0], step, {0}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double count =
        is_even(steps[i]) ? 1
                          : std::min(std::round(steps[i] / step), static_cast<double>(max_missing));
    if (!is_even(steps[i]) &&
        !(count >= 2 && std::fabs(steps[i] - count * step) <= tolerance * step)) {
      odd = {step, i};
      return std::nullopt;
    }
    slices.numbers.push_back(slices.numbers.back() + static_cast<std::uint64_t>(count));
  }
  slices.step = (along.back() - along[0]) / static_cast<double>(slices.numbers.back());
  return slices;
}

}  // namespace discmc::command
