#include "label_run.hpp"

#include <algorithm>
#include <stdexcept>

#include "require.hpp"
#include "selection.hpp"

namespace discmc::meshing {
namespace {

// Slices without a voxel that go before the first one with any. A run that does not begin at the
// bottom of the volume is a slab. The slice below it and its own first one are empty, so nothing
// crosses its seam.
std::uint32_t empty_slices_before(std::uint32_t first) {
  return std::min<std::uint32_t>(first, 2);
}

Slab slab_from(std::uint32_t first) {
  return first < 2 ? Slab{} : Slab{first - 1, true, false};
}

// A run that needs more sends loose fragments, which are joined.
std::uint64_t arena_bytes(const Limits& limits) {
  constexpr std::uint64_t plenty = std::uint64_t{4} << 20;
  return std::max(plenty, 2 * Extractor32::minimum_bytes(limits));
}

}  // namespace

std::uint64_t LabelRun::bytes_for(const Limits& limits) {
  // The extractor, the filter and the slice under way; and the joiner.
  return Extractor32::minimum_bytes(limits) + MajorityFilter::bytes_for(limits) +
         bit_row_bytes(limits.width) * std::uint64_t{limits.height} +
         GrowingJoiner::first_bytes / 8;
}

LabelRun::LabelRun(const Limits& limits, std::uint32_t first, bool takes_majority, const Sink& sink)
    : limits_(limits),
      row_bytes_(bit_row_bytes(limits.width)),
      slice_(row_bytes_ * limits.height),
      joiner_(sink) {
  limits_.slab = slab_from(first);
  const std::uint64_t bytes = arena_bytes(limits_);
  // Left as it comes: what is never used costs nothing.
  arena_.reset(new std::uint8_t[bytes]);
  constexpr std::int32_t no_threshold = 0;
  require(extractor_.start(limits_, no_threshold, {arena_.get(), bytes}, make_sink(joiner_)));
  if (takes_majority) filter_ = std::make_unique<OwnFilter>(limits_);
  for (std::uint32_t i = 0; i < empty_slices_before(first); ++i) end_slice();
  slices_without_voxels_ = 0;
}

void LabelRun::set(std::uint32_t y, std::uint32_t begin, std::uint32_t end) {
  std::uint8_t* const row = slice_.data() + y * row_bytes_;
  const auto from_bit = [](std::uint32_t x) { return static_cast<std::uint8_t>(0xFFU << (x % 8)); };
  const std::uint32_t last = end - 1;
  const auto to_last = static_cast<std::uint8_t>(0xFFU >> (7 - last % 8));
  has_voxels_ = true;
  if (begin / 8 == last / 8) {
    row[begin / 8] = static_cast<std::uint8_t>(row[begin / 8] | (from_bit(begin) & to_last));
    return;
  }
  row[begin / 8] = static_cast<std::uint8_t>(row[begin / 8] | from_bit(begin));
  std::fill(row + begin / 8 + 1, row + last / 8, std::uint8_t{0xFF});
  row[last / 8] = static_cast<std::uint8_t>(row[last / 8] | to_last);
}

void LabelRun::end_slice() {
  for (std::uint32_t y = 0; y < limits_.height; ++y) push(slice_.data() + y * row_bytes_);
  slices_without_voxels_ = has_voxels_ ? 0 : slices_without_voxels_ + 1;
  if (has_voxels_) std::fill(slice_.begin(), slice_.end(), std::uint8_t{0});
  has_voxels_ = false;
}

void LabelRun::finish() {
  while (const std::uint8_t* row = filter_ ? filter_->filter.drain() : nullptr)
    require(extractor_.push_bits(row).status);
  require(extractor_.finish());
}

void LabelRun::push(const std::uint8_t* row) {
  if (filter_) row = filter_->filter.push(row);
  if (row != nullptr) require(extractor_.push_bits(row).status);
}

}  // namespace discmc::meshing
