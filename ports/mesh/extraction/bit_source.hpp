// The bits of a volume, row by row, as extractors take them.
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

/// Rows of bits from samples: those of all surfaces side by side, as SurfaceGroup and SliceEncoder
/// take them.
class BitSource {
 public:
  /// limits: with the slab that the spans are of.
  BitSource(const SampleGrid& info, const Limits& limits, const SlabSpans& spans,
            bool takes_majority, const std::vector<SurfaceRequest>& surfaces)
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
      if (takes_majority) filters_.push_back(std::make_unique<OwnFilter>(limits));
    }
  }

  /// Takes the next slice of those that are read, and calls for every row that is given and due
  /// after it. mask: the rows of its mask, if it has one.
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
  /// Calls for the rows that are left.
  template <class Call>
  void finish(Call call) {
    while (filter_next([](OwnFilter& own, std::size_t) { return own.filter.drain(); }))
      pass_on(filtered_.data(), call);
  }

  /// The rows of its own slices.
  std::uint64_t not_numbers() const { return not_numbers_; }
  bool is_full(std::size_t surface) const { return is_full_[surface]; }

 private:
  template <class Call>
  void add_row(std::uint8_t* row, Call call) {
    if (filters_.empty()) return pass_on(row, call);
    if (filter_next(
            [&](OwnFilter& own, std::size_t i) { return own.filter.push(row + i * row_bytes_); }))
      pass_on(filtered_.data(), call);
  }
  // Gives the filters, which are all where the first one is, what is next. Returns whether each has
  // a row.
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
  void pass_on(std::uint8_t* row, Call call) {
    if (!mask_.empty()) apply_mask(row);
    if (!spans_.given.holds(static_cast<std::uint32_t>(row_++ / height_))) return;
    for (std::size_t i = 0; i < is_full_.size(); ++i)
      is_full_[i] =
          is_full_[i] && std::equal(full_row_.begin(), full_row_.end(), row + i * row_bytes_);
    call(row);
  }
  // The mask comes after the filters, which would turn voxels beside its edge on again.
  void apply_mask(std::uint8_t* row) {
    const auto end = mask_.begin() + static_cast<std::ptrdiff_t>(row_bytes_);
    for (std::size_t i = 0; i < is_full_.size(); ++i)
      keep_masked(row + i * row_bytes_, mask_.begin(), row_bytes_);
    mask_.erase(mask_.begin(), end);
  }

  SlabSpans spans_;
  std::uint32_t slice_;  // the next one
  std::uint64_t row_;    // the next one to be passed on
  std::uint32_t height_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> bits_;      // of a slice
  std::vector<std::uint8_t> filtered_;  // a row
  std::vector<std::uint8_t> full_row_;
  std::vector<bool> is_full_;      // so far, of each surface
  std::deque<std::uint8_t> mask_;  // rows of the mask that are not yet due
  std::vector<SliceSelector> selectors_;
  std::vector<std::unique_ptr<OwnFilter>> filters_;
  std::uint64_t not_numbers_ = 0;
};

}  // namespace discmc::meshing

#endif
