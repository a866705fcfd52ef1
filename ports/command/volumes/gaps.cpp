#include "gaps.hpp"

#include <algorithm>
#include <numeric>

#include "volume_error.hpp"

namespace discmc::command {
namespace {

std::string are_missing(const std::vector<Gap>& gaps) {
  const std::uint64_t slices = missing_slices(gaps);
  const auto largest = std::max_element(
      gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.missing < b.missing; });
  return std::to_string(slices) + (slices == 1 ? " slice is missing" : " slices are missing") +
         (gaps.size() == 1 ? " " : ", the largest of " + std::to_string(gaps.size()) + " gaps ") +
         largest->place;
}

}  // namespace

std::uint64_t missing_slices(const std::vector<Gap>& gaps) {
  return std::accumulate(gaps.begin(), gaps.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Gap& gap) { return sum + gap.missing; });
}

std::string note_of_filling(const std::filesystem::path& source, const std::vector<Gap>& gaps,
                            std::size_t slices, bool is_allowed, const std::string& remedy) {
  const std::string what = are_missing(gaps);
  if (missing_slices(gaps) > slices) fail(source, what + ", which is too many to fill", remedy);
  if (!is_allowed) fail(source, what, remedy + ", or repeat the nearest slice with --allow-gaps");
  return what + ", and filled with the nearest ones";
}

}  // namespace discmc::command
