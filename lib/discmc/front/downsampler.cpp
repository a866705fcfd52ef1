#include <discmc/front/downsampler.hpp>

namespace discmc {

namespace {

constexpr uint64_t max_voxels = uint64_t{Downsampler<uint16_t>::max_extent} *
                                Downsampler<uint16_t>::max_extent *
                                Downsampler<uint16_t>::max_extent;
static_assert(max_voxels * UINT16_MAX + max_voxels / 2 <= UINT32_MAX, "the sum of a block fits");

}  // namespace

template <class Sample>
Status Downsampler<Sample>::start(const Limits& incoming, uint32_t extent, Memory memory) {
  sums_ = nullptr;
  if (!incoming.is_valid() || extent == 0 || extent > max_extent) return Status::bad_limits;
  Arena arena(memory);
  const Limits limits{blocks(incoming.width, extent), blocks(incoming.height, extent),
                      incoming.border};
  uint32_t* const sums = arena.allocate<uint32_t>(limits.width * limits.height);
  means_ = arena.allocate<Sample>(limits.width);
  if (arena.is_exhausted()) return Status::too_little_memory;
  for (uint32_t i = 0; i < limits.width * limits.height; ++i) sums[i] = 0;
  sums_ = sums;
  limits_ = limits;
  incoming_ = incoming;
  extent_ = extent;
  row_ = slice_ = row_in_block_ = block_ = 0;
  return Status::ok;
}

// Returns the extent of a block on an axis of this many voxels.
template <class Sample>
uint32_t Downsampler<Sample>::size_of(uint32_t block, uint32_t voxels) const {
  const uint32_t left = voxels - block * extent_;
  return left < extent_ ? left : extent_;
}

template <class Sample>
const Sample* Downsampler<Sample>::push(const Sample* samples) {
  uint32_t* sum = sums_ + size_t{block_} * limits_.width;
  for (uint32_t left = incoming_.width; left > 0;) {
    const uint32_t count = left < extent_ ? left : extent_;
    uint32_t added = 0;
    for (uint32_t i = 0; i < count; ++i) added += static_cast<uint32_t>(*samples++ - min_sample);
    *sum++ += added;
    left -= count;
  }
  ++row_;
  const bool is_last_row = row_ == incoming_.height;
  const bool ends_block = ++row_in_block_ == extent_ || is_last_row;
  const Sample* const means = ends_block && slice_ + 1 == extent_ ? next_row(extent_) : nullptr;
  if (ends_block) row_in_block_ = 0;
  if (ends_block && means == nullptr) ++block_;
  if (is_last_row) {
    row_ = block_ = 0;
    slice_ = slice_ + 1 == extent_ ? 0 : slice_ + 1;
  }
  return means;
}

template <class Sample>
const Sample* Downsampler<Sample>::drain() {
  return slice_ > 0 && block_ < limits_.height ? next_row(slice_) : nullptr;
}

// Computes the means of a row of blocks, and resets their sums.
template <class Sample>
const Sample* Downsampler<Sample>::next_row(uint32_t slices) {
  uint32_t* const sums = sums_ + size_t{block_} * limits_.width;
  const uint32_t area = slices * size_of(block_, incoming_.height);
  for (uint32_t x = 0; x < limits_.width; ++x) {
    const uint32_t count = area * size_of(x, incoming_.width);
    means_[x] =
        static_cast<Sample>(static_cast<int32_t>((sums[x] + count / 2) / count) + min_sample);
    sums[x] = 0;
  }
  ++block_;
  return means_;
}

template class Downsampler<uint8_t>;
template class Downsampler<uint16_t>;
template class Downsampler<int16_t>;

}  // namespace discmc
