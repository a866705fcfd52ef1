// The last rows of samples, and the gradient at a vertex.
//
// The gradient is the sum of central differences at the voxels around the vertex. A midpoint has
// the two ends of its edge, a centroid the eight corners of its cell. The differences are one-sided
// at the outermost voxels of the volume.
#ifndef DISCMC_TRACE_SAMPLE_ROWS_HPP
#define DISCMC_TRACE_SAMPLE_ROWS_HPP

#include <discmc/base/arena.hpp>
#include <discmc/limits.hpp>
#include <discmc/normal.hpp>

namespace discmc::detail::trace {

/// A ring of rows. Sample is uint8_t, uint16_t or int16_t.
template <class Sample>
class SampleRows {
 public:
  /// Returns the bytes that start() allocates in the arena.
  static constexpr uint64_t bytes_for(const Limits& limits, uint32_t ring_rows) {
    return Arena::bytes_of(limits.width * ring_rows, sizeof(Sample));
  }
  /// Allocates ring_rows rows in the arena, and writes nothing.
  void start(Arena& arena, const Limits& limits, uint32_t ring_rows);
  void clear();

  /// Appends samples to the arriving row; `stride` counts samples from one to the next. Limit:
  /// count <= width - column(). Cost: a copy.
  void append(const Sample* samples, uint32_t count, uint32_t stride);
  /// Fills the rest of the row with one value.
  void fill(Sample value);
  /// Fills the whole row with the previous row, or the first row of all with `first`. Limit:
  /// column() == 0.
  void repeat(Sample first);

  uint32_t column() const { return column_; }
  bool is_row_complete() const { return column_ == width_; }
  /// Begins the next row, and after the last row of a slice the next slice.
  void next_row();

  /// Return the number of complete rows of the arriving slice (0 to height - 1), and of complete
  /// slices.
  uint32_t rows() const { return rows_; }
  uint32_t slices() const { return slices_; }

  /// Returns the row that arrived `back` rows ago. Limit: 1 <= back < ring_rows, or ring_rows while
  /// the next row has no samples.
  const Sample* row_before(uint32_t back) const { return row_at(index_before(back)); }
  /// Returns the index of that row in the ring, 0 to ring_rows - 1; of the arriving row for 0.
  uint32_t index_before(uint32_t back) const {
    return row_index_ >= back ? row_index_ - back : row_index_ + ring_rows_ - back;
  }

  /// Returns the direction in which the samples fall, from on to off: the negative gradient. It is
  /// zero if the samples are level, and outside the volume, on the walls that Border::closed adds.
  /// Units: samples per voxel, times 4 for a midpoint and 16 for a centroid; less than 2^21. Limit:
  /// the ring has the needed rows; slices that have not arrived do not belong to the volume. Cost:
  /// 12 samples for a midpoint, 48 for a centroid.
  LongVector negative_gradient(const Vertex& vertex) const;

 private:
  Sample* row_at(uint32_t index) const { return ring_ + size_t{index} * width_; }
  bool has_row(uint32_t y, uint32_t z) const { return z < slices_ || (z == slices_ && y < rows_); }
  const Sample* row(uint32_t y, uint32_t z) const {
    return row_before((slices_ - z) * height_ + rows_ - y);
  }

  struct Slope {
    int32_t x, y, z;
  };
  void add_row(Slope& slope, uint32_t x, uint32_t last_x, uint32_t y, uint32_t z) const;

  Sample* ring_ = nullptr;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t ring_rows_ = 0;
  uint32_t row_index_ = 0;  // of the arriving row
  uint32_t column_ = 0;
  uint32_t rows_ = 0;
  uint32_t slices_ = 0;
};

extern template class SampleRows<uint8_t>;
extern template class SampleRows<uint16_t>;
extern template class SampleRows<int16_t>;

}  // namespace discmc::detail::trace

#endif
