// Makes the bits of a volume, row by row, for extractors.
#ifndef DISCMC_MESH_EXTRACTION_BIT_SOURCE_HPP
#define DISCMC_MESH_EXTRACTION_BIT_SOURCE_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "mask_bits.hpp"
#include "own_filter.hpp"
#include "selection.hpp"
#include "slab_spans.hpp"
#include "surfaces.hpp"

namespace discmc::meshing {

/// Makes rows of bits from samples, with adjacent rows for all surfaces, as SurfaceGroup and
/// SliceEncoder expect them.
class BitSource {
 public:
  /// limits: with the slab of the spans.
  BitSource(const SampleGrid& info, const Limits& limits, const SlabSpans& spans,
            bool filters_by_majority, const std::vector<SurfaceRequest>& surfaces)
      : spans_(spans),
        slice_(spans.read.first),
        row_(std::uint64_t{spans.read.first} * limits.height),
        height_(limits.height),
        row_bytes_(bit_row_bytes(limits.width)),
        bits_(row_bytes_ * surfaces.size() * height_),
        filtered_(row_bytes_ * surfaces.size()),
        full_row_(row_bytes_, 0xff),
        is_full_(surfaces.size(), true) {
    if (limits.width % 8 != 0)
      full_row_.back() = static_cast<std::uint8_t>((1U << limits.width % 8) - 1);
    for (const SurfaceRequest& surface : surfaces) {
      selectors_.emplace_back(info, surface.selection);
      if (filters_by_majority) filters_.push_back(std::make_unique<OwnFilter>(limits));
    }
  }

  /// Processes the next slice to read, and calls `call` for every row to push that is then due.
  /// mask: the rows of its mask, if there is one.
  template <class Call>
  void add_slice(const void* samples, const std::uint8_t* mask, Call call) {
    if (mask != nullptr) mask_.insert(mask_.end(), mask, mask + row_bytes_ * height_);
    const std::size_t stride = filtered_.size();
    for (std::size_t i = 0; i < selectors_.size(); ++i) {
      const auto not_numbers = selectors_[i].select(samples, bits_.data() + i * row_bytes_, stride);
      if (i == 0 && spans_.own.holds(slice_)) not_numbers_ += not_numbers;
    }
    ++slice_;
    for (std::uint32_t y = 0; y < height_; ++y) add_row(bits_.data() + y * stride, call);
  }
  /// Calls `call` for the remaining rows.
  template <class Call>
  void finish(Call call) {
    while (filter_next([](OwnFilter& own, std::size_t) { return own.filter.drain(); }))
      push_row(filtered_.data(), call);
  }

  /// Counts NaN in rows of its own slices.
  std::uint64_t not_numbers() const { return not_numbers_; }
  bool is_full(std::size_t surface) const { return is_full_[surface]; }

 private:
  template <class Call>
  void add_row(std::uint8_t* row, Call call) {
    if (filters_.empty()) return push_row(row, call);
    if (filter_next(
            [&](OwnFilter& own, std::size_t i) { return own.filter.push(row + i * row_bytes_); }))
      push_row(filtered_.data(), call);
  }
  // Passes the next row to the filters, which all are at one position. Returns whether each filter
  // has a row.
  template <class Next>
  bool filter_next(Next next) {
    bool has_row = false;
    for (std::size_t i = 0; i < filters_.size(); ++i) {
      const std::uint8_t* const row = next(*filters_[i], i);
      has_row = row != nullptr;
      if (has_row) std::copy(row, row + row_bytes_, filtered_.data() + i * row_bytes_);
    }
    return has_row;
  }
  template <class Call>
  void push_row(std::uint8_t* row, Call call) {
    if (!mask_.empty()) apply_mask(row);
    if (!spans_.pushed.holds(static_cast<std::uint32_t>(row_++ / height_))) return;
    for (std::size_t i = 0; i < is_full_.size(); ++i)
      is_full_[i] =
          is_full_[i] && std::equal(full_row_.begin(), full_row_.end(), row + i * row_bytes_);
    call(row);
  }
  // Applies the mask after the filters, which would turn on voxels beside its edge again.
  void apply_mask(std::uint8_t* row) {
    const auto end = mask_.begin() + static_cast<std::ptrdiff_t>(row_bytes_);
    for (std::size_t i = 0; i < is_full_.size(); ++i)
      keep_masked(row + i * row_bytes_, mask_.begin(), row_bytes_);
    mask_.erase(mask_.begin(), end);
  }

  SlabSpans spans_;
  std::uint32_t slice_;  // next slice
  std::uint64_t row_;    // next row to push
  std::uint32_t height_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> bits_;      // of the current slice
  std::vector<std::uint8_t> filtered_;  // one row
  std::vector<std::uint8_t> full_row_;
  std::vector<bool> is_full_;      // so far, per surface
  std::deque<std::uint8_t> mask_;  // rows of the mask that are not due yet
  std::vector<SliceSelector> selectors_;
  std::vector<std::unique_ptr<OwnFilter>> filters_;
  std::uint64_t not_numbers_ = 0;
};

}  // namespace discmc::meshing

#endif
