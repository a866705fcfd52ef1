// Slices that are missing within a stack of files: refused, or filled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace discmc::command {

/// The largest number of missing slices in a gap.
constexpr std::uint64_t max_missing = 1000000000;

/// A place where slices are missing.
struct Gap {
  /// The index of the slice before the gap, from 0.
  std::size_t slice = 0;
  /// Limit: max_missing.
  std::uint64_t missing = 0;
  /// Text for people: "between a7.png and a9.png".
  std::string place;
};

/// Returns the total number of missing slices.
std::uint64_t missing_slices(const std::vector<Gap>& gaps);

/// Returns the note that gaps are filled. Throws VolumeError with the remedy if this is not
/// allowed, or if more slices are missing than exist. Limit: at least one gap.
std::string note_of_filling(const std::filesystem::path& source, const std::vector<Gap>& gaps,
                            std::size_t slices, bool is_allowed, const std::string& remedy);

/// Replaces each missing slice by the nearest one, or by the earlier of two equally near ones.
template <class Slice>
void fill_gaps(std::vector<Slice>& stack, const std::vector<Gap>& gaps) {
  std::vector<Slice> filled;
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < stack.size(); ++i) {
    filled.push_back(stack[i]);
    if (gap == gaps.end() || gap->slice != i) continue;
    const std::size_t nearer_next = gap->missing / 2;
    filled.insert(filled.end(), gap->missing - nearer_next, stack[i]);
    filled.insert(filled.end(), nearer_next, stack[i + 1]);
    ++gap;
  }
  stack = std::move(filled);
}

}  // namespace discmc::command
