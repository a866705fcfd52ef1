#include "closed_volume.hpp"

#include <algorithm>
#include <array>

namespace discmc::meshing {
namespace {

BitGrid padded_by(const std::array<std::uint32_t, 3>& voxels, BitGrid grid) {
  for (std::size_t axis = 0; axis < 3; ++axis) grid.dims[axis] += 2 * voxels[axis];
  return grid;
}

}  // namespace

ClosedVolume::ClosedVolume(SliceReader& volume, const Selection& selection, SliceReader* mask,
                           double radius_mm)
    : selected_(volume, selection, mask),
      info_(info_of_mask(volume.info(), SampleType::u8)),
      ball_(radius_mm, info_.distances_mm()),
      padded_(padded_by(ball_.reach, {info_.dims})),
      dilation_(padded_, ball_, [this](std::uint64_t* bits) { read_padded(bits); }),
      erosion_(padded_, ball_, [this](std::uint64_t* bits) { read_complement(bits); }),
      eroded_(padded_.slice_words()) {}

void ClosedVolume::read_slice(void* samples) {
  const std::uint32_t before = slices_ == 0 ? ball_.reach[2] : 0;
  for (std::uint32_t i = 0; i <= before; ++i) erosion_.next(eroded_.data());
  ++slices_;
  auto* sample = static_cast<std::uint8_t*>(samples);
  for (std::uint32_t y = 0; y < info_.dims[1]; ++y) {
    const std::uint64_t* const row = eroded_.data() + (y + ball_.reach[1]) * padded_.row_words();
    for (std::uint32_t x = ball_.reach[0]; x < info_.dims[0] + ball_.reach[0]; ++x)
      *sample++ = (row[x / 64] >> x % 64 & 1) == 0 ? 1 : 0;
  }
}

void ClosedVolume::read_padded(std::uint64_t* bits) {
  std::fill_n(bits, padded_.slice_words(), 0);
  const std::uint32_t z = padded_slices_++;
  if (z < ball_.reach[2] || z >= ball_.reach[2] + info_.dims[2]) return;
  const std::uint8_t* const slice = selected_.next_slice();
  for (std::uint32_t y = 0; y < info_.dims[1]; ++y) {
    const std::uint8_t* const row = slice + y * bit_row_bytes(info_.dims[0]);
    std::uint64_t* const to = bits + (y + ball_.reach[1]) * padded_.row_words();
    for (std::uint32_t x = 0; x < info_.dims[0]; ++x) {
      const std::uint32_t bit = x + ball_.reach[0];
      to[bit / 64] |= std::uint64_t{unsigned{row[x / 8]} >> x % 8 & 1U} << bit % 64;
    }
  }
}

void ClosedVolume::read_complement(std::uint64_t* bits) {
  dilation_.next(bits);
  std::transform(bits, bits + padded_.slice_words(), bits,
                 [](std::uint64_t word) { return ~word; });
}

}  // namespace discmc::meshing
