// The number of voxels and runs that a stream of slices codes, which determines the encoder's time.
// This header uses only the library, so that boards can count them, too.
#pragma once

#include <discmc/slice_encoder.hpp>

namespace discmc::command {

class SliceSteps {
 public:
  /// memory: SliceEncoder::minimum_bytes() of the limits; Owner: the caller.
  void start(const Limits& limits, uint32_t key_slice_interval, Memory memory) {
    discmc::Arena arena(memory);
    model_.start(arena, false);
    rows_.start(arena, limits, detail::slices::rows_kept(limits.height, key_slice_interval == 1));
    rows_.clear();
    limits_ = limits;
    key_slice_interval_ = key_slice_interval;
  }

  /// Accepts a row like SliceEncoder.
  void push_bits(const uint8_t* bits) {
    rows_.append_bits(bits);
    count_row();
  }
  template <class Sample>
  void push(const Sample* samples, int32_t threshold) {
    rows_.append(samples, limits_.width, 1, threshold);
    count_row();
  }

  uint64_t count() const { return count_; }

 private:
  struct NoCoder {
    bool code_bit(LearntProbability&, bool bit) { return bit; }
    uint32_t raw_bits(uint32_t, uint32_t value) { return value; }
  };

  void count_row() {
    const auto kind = detail::slices::is_key_slice(rows_.slices(), key_slice_interval_)
                          ? detail::slices::SliceKind::key
                          : detail::slices::SliceKind::follows;
    detail::slices::RowCode row;
    row.begin(rows_.arriving(), detail::slices::rows_before(rows_, limits_.height, kind),
              limits_.width);
    NoCoder coder;
    for (; !row.is_done(); ++count_) row.step(coder, model_);
    rows_.next_row();
    if (rows_.rows() == limits_.height) rows_.next_slice();
  }

  detail::trace::BitRows rows_;
  detail::slices::SliceModel model_;
  Limits limits_{};
  uint32_t key_slice_interval_ = 0;
  uint64_t count_ = 0;
};

}  // namespace discmc::command
