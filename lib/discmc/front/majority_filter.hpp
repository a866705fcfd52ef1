// A majority filter, as a stage before the extractor. It sets a voxel if most of the 27 voxels of
// its 3 x 3 x 3 block are on. It removes noise and specks, and leaves walls in place.
//
//   filter.start(limits, memory);
//   for each row of bits:
//     if (const uint8_t* row = filter.push(bits)) extractor.push_bits(row);
//   while (const uint8_t* row = filter.drain()) extractor.push_bits(row);
//
// The filter delays rows by a slice and a row. Beyond the sides of the volume it repeats the
// outermost voxels.
#ifndef DISCMC_MAJORITY_FILTER_HPP
#define DISCMC_MAJORITY_FILTER_HPP

#include <discmc/base/arena.hpp>
#include <discmc/limits.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Rows of bits in, filtered rows of bits out. It is neither copied nor moved: two copies would
/// write to the same memory.
class MajorityFilter {
 public:
  MajorityFilter() = default;
  MajorityFilter(const MajorityFilter&) = delete;
  MajorityFilter& operator=(const MajorityFilter&) = delete;

  /// The memory for start(): two slices of bits and four rows. Units: bytes.
  static constexpr uint64_t bytes_for(const Limits& limits) {
    return Arena::bytes_of(rows_held(limits) + 1, 4 * words_of(limits.width)) + red_zone_bytes +
           Arena::alignment - 1;
  }

  /// Begins a volume. memory: at least bytes_for(limits); Owner: the caller, while the filter is in
  /// use. Errors: bad_limits, too_little_memory; then the filter is not started. Cost: nothing is
  /// written.
  [[nodiscard]] Status start(const Limits& limits, Memory memory);

  /// Accepts the next row, eight voxels per byte, the first in bit 0. Returns the row that is due,
  /// in the same form with unused bits off, or null; Owner: the filter, until the next call. Limit:
  /// started, before drain(). Cost: about 20 instructions per voxel on a Cortex-M4.
  const uint8_t* push(const uint8_t* bits);

  /// Returns the next of the rows left after the last push(), or null at the end; Owner and cost:
  /// as push(). Limit: started, and whole slices.
  const uint8_t* drain();

 private:
  static constexpr uint32_t words_of(uint32_t width) { return (width + 31) / 32; }
  // From the row before the due row, a slice below, to the row behind it, a slice above.
  static constexpr uint32_t rows_held(const Limits& limits) { return 2 * limits.height + 3; }

  // A held row, relative to the due row: y from -1 to 1, z from -1 to 1.
  const uint32_t* held(int32_t y, int32_t z) const;
  const uint8_t* next_row(bool is_last_slice);
  uint32_t majority_at(const uint32_t* const (&rows)[9], uint32_t word) const;

  Limits limits_{};
  uint32_t* rows_ = nullptr;  // a ring of rows_held() rows
  uint8_t* due_ = nullptr;
  uint32_t push_index_ = 0;     // in the ring, of the next pushed row
  uint32_t due_index_ = 0;      // in the ring, of the next due row
  uint32_t due_y_ = 0;          // in its slice
  bool is_first_slice_ = true;  // of the due row
  uint32_t waiting_ = 0;        // rows that were pushed and are not due yet
};

}  // namespace discmc

#endif
