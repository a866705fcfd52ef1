// What classic Marching Cubes would make of a surface: how many vertices.
#ifndef DISCMC_COMMAND_EXTRACTION_CROSSING_COUNTER_HPP
#define DISCMC_COMMAND_EXTRACTION_CROSSING_COUNTER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/limits.hpp>

namespace discmc::command {

/// Counts the lattice edges between an on and an off voxel: classic Marching Cubes puts a vertex on
/// each of them. Of a slab: those in its own slices, and between the first one and that below.
class CrossingCounter {
 public:
  /// limits: of the slab, if it is one.
  explicit CrossingCounter(const Limits& limits);

  /// Takes the next row, as Extractor::push_bits() does, but with unused bits off.
  void add_row(const std::uint8_t* bits);

  /// After the last row.
  std::uint64_t count() const;

 private:
  // Around a closed volume all is off; around an open one is what is at its side, so that nothing
  // crosses there.
  std::uint64_t changes_along(const std::uint8_t* row) const;
  void end_slice();

  std::uint32_t width_;
  std::uint32_t height_;
  bool is_closed_;
  bool is_context_;  // the slice under way, which lies below the slab
  bool continues_above_;
  std::vector<std::uint8_t> off_;   // a row
  std::vector<std::uint8_t> rows_;  // a slice of them: of this one so far, then of the one before
  std::uint32_t y_ = 0;
  bool has_below_;
  std::uint64_t count_ = 0;
  // When the last slice had come, and the one before it: the last one may lie above the slab.
  std::uint64_t count_at_slice_ = 0, count_before_slice_ = 0;
};

}  // namespace discmc::command

#endif
