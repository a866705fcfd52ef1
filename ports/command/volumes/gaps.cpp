#include "gaps.hpp"

#include <numeric>

#include "volume_format.hpp"

namespace discmc::host {
namespace {

std::string are_missing(std::uint64_t slices) {
  return std::to_string(slices) + (slices == 1 ? " slice is missing" : " slices are missing");
}

}  // namespace

std::uint64_t missing_slices(const std::vector<Gap>& gaps) {
  return std::accumulate(gaps.begin(), gaps.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Gap& gap) { return sum + gap.missing; });
}

bool can_be_filled(const std::vector<Gap>& gaps, std::size_t slices) {
  return missing_slices(gaps) <= slices;
}

std::string note_of_filling(const std::filesystem::path& source, const std::vector<Gap>& gaps,
                            std::size_t slices, bool is_allowed) {
  const std::string first = are_missing(gaps[0].missing) + ' ' + gaps[0].place;
  if (!can_be_filled(gaps, slices))
    fail(source, first + ", which is too much to be filled", "export or copy the series again");
  if (!is_allowed)
    fail(source, first,
         "export or copy the series again, or let --allow-gaps repeat the nearest slice");
  if (gaps.size() == 1) return first + ", filled with the nearest ones";
  return are_missing(missing_slices(gaps)) + ", the first of " + std::to_string(gaps.size()) +
         " gaps " + gaps[0].place + ", filled with the nearest ones";
}

}  // namespace discmc::host
