#include <discmc/trace/sample_rows.hpp>

namespace discmc::detail::trace {

template <class Sample>
void SampleRows<Sample>::start(Arena& arena, const Limits& limits, uint32_t ring_rows) {
  width_ = limits.width;
  height_ = limits.height;
  ring_rows_ = ring_rows;
  ring_ = arena.allocate<Sample>(limits.width * ring_rows);
}

template <class Sample>
void SampleRows<Sample>::clear() {
  row_index_ = 0;
  column_ = 0;
  rows_ = 0;
  slices_ = 0;
}

template <class Sample>
void SampleRows<Sample>::append(const Sample* samples, uint32_t count, uint32_t stride) {
  Sample* const row = row_at(row_index_) + column_;
  for (size_t i = 0; i < count; ++i) row[i] = samples[i * stride];
  column_ += count;
}

template <class Sample>
void SampleRows<Sample>::fill(Sample value) {
  Sample* const row = row_at(row_index_);
  for (; column_ < width_; ++column_) row[column_] = value;
}

template <class Sample>
void SampleRows<Sample>::repeat(Sample first) {
  if (rows_ == 0 && slices_ == 0) return fill(first);
  append(row_before(1), width_, 1);
}

template <class Sample>
void SampleRows<Sample>::next_row() {
  column_ = 0;
  if (++row_index_ == ring_rows_) row_index_ = 0;
  if (++rows_ < height_) return;
  rows_ = 0;
  ++slices_;
}

template <class Sample>
LongVector SampleRows<Sample>::negative_gradient(const Vertex& vertex) const {
  // A negative coordinate then exceeds the volume.
  const uint32_t x = static_cast<uint32_t>(vertex.x), last_x = x / 2 + x % 2;
  const uint32_t y = static_cast<uint32_t>(vertex.y), last_y = y / 2 + y % 2;
  const uint32_t z = static_cast<uint32_t>(vertex.z), last_z = z / 2 + z % 2;
  if (last_x >= width_ || last_y >= height_ || !has_row(last_y, last_z)) return {0, 0, 0};
  Slope slope{0, 0, 0};
  for (uint32_t k = z / 2; k <= last_z; ++k)
    for (uint32_t j = y / 2; j <= last_y; ++j) add_row(slope, x / 2, last_x, j, k);
  return {slope.x, slope.y, slope.z};
}

// Adds the slope of the samples at voxels x to last_x of a row, over two steps each. The voxel
// itself replaces a missing neighbour, and the remaining step counts twice.
template <class Sample>
void SampleRows<Sample>::add_row(Slope& slope, uint32_t x, uint32_t last_x, uint32_t y,
                                 uint32_t z) const {
  const Sample* const here = row(y, z);
  const bool has_front = y > 0, has_back = y + 1 < height_;
  const bool has_below = z > 0, has_above = has_row(y, z + 1);
  const Sample* const front = has_front ? row(y - 1, z) : here;
  const Sample* const back = has_back ? row(y + 1, z) : here;
  const Sample* const below = has_below ? row(y, z - 1) : here;
  const Sample* const above = has_above ? row(y, z + 1) : here;
  const int32_t times_y = has_front && has_back ? 1 : 2;
  const int32_t times_z = has_below && has_above ? 1 : 2;
  for (uint32_t i = x; i <= last_x; ++i) {
    const uint32_t left = i > 0 ? i - 1 : 0;
    const uint32_t right = i + 1 < width_ ? i + 1 : i;
    const int32_t times_x = right - left == 2 ? 1 : 2;
    slope.x += times_x * (int32_t{here[left]} - here[right]);
    slope.y += times_y * (int32_t{front[i]} - back[i]);
    slope.z += times_z * (int32_t{below[i]} - above[i]);
  }
}

template class SampleRows<uint8_t>;
template class SampleRows<uint16_t>;
template class SampleRows<int16_t>;

}  // namespace discmc::detail::trace
