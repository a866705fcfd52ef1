#include <discmc/front/row_ring.hpp>

namespace discmc {

void* RowRing::free_row(uint32_t ahead) const {
  if (ahead >= room_ || filled_ - load_acquire(emptied_) >= room_ - ahead) return nullptr;
  const uint32_t left = room_ - fill_index_;
  const uint32_t index = ahead < left ? fill_index_ + ahead : ahead - left;
  return rows_ + size_t{index} * row_bytes_;
}

void RowRing::commit() {
  numbers_[fill_index_] = produced_;
  fill_index_ = fill_index_ + 1 == room_ ? 0 : fill_index_ + 1;
  store_release(filled_, filled_ + 1);
  store_release(produced_, produced_ + 1);
}

RowRing::Next RowRing::peek() const {
  // Reads in the reverse order of the writes. Every counted row is therefore visible, and the last
  // row is visible if the end is.
  const bool was_last = load_acquire(ended_) != 0;
  const uint32_t incoming = load_acquire(produced_);
  const bool is_there = load_acquire(filled_) != emptied_;
  if (is_there && numbers_[empty_index_] == consumed_) return Next::ready;
  // A popped row may not be counted yet: then consumed_ is ahead.
  const bool is_behind = static_cast<int32_t>(incoming - consumed_) > 0;
  if (is_there || is_behind) return Next::lost;
  return was_last ? Next::end : Next::none;
}

void RowRing::pop() {
  const bool is_row = load_acquire(filled_) != emptied_ && numbers_[empty_index_] == consumed_;
  ++consumed_;
  if (!is_row) return;
  empty_index_ = empty_index_ + 1 == room_ ? 0 : empty_index_ + 1;
  store_release(emptied_, emptied_ + 1);
}

}  // namespace discmc
