#include <discmc/row_ring.hpp>

namespace discmc {

Status RowRing::start(uint32_t row_bytes, uint32_t rows, Memory memory) {
  const uint64_t bytes = bytes_for(row_bytes, rows);
  if (row_bytes == 0 || rows == 0 || bytes > UINT32_MAX) return Status::bad_capacities;
  if (memory.data == nullptr || memory.bytes < bytes) return Status::too_little_memory;
  Arena arena(memory);
  row_bytes_ = static_cast<uint32_t>(Arena::bytes_of(1, row_bytes));
  rows_ = arena.take<uint8_t>(row_bytes_ * rows);
  numbers_ = arena.take<uint32_t>(rows);
  room_ = rows;
  filled_ = came_ = ended_ = fill_place_ = 0;
  emptied_ = passed_ = empty_place_ = 0;
  return Status::ok;
}

void* RowRing::free_row(uint32_t ahead) const {
  if (ahead >= room_ || filled_ - load_acquire(emptied_) >= room_ - ahead) return nullptr;
  const uint32_t left = room_ - fill_place_;
  const uint32_t place = ahead < left ? fill_place_ + ahead : ahead - left;
  return rows_ + size_t{place} * row_bytes_;
}

void RowRing::fill() {
  numbers_[fill_place_] = came_;
  fill_place_ = fill_place_ + 1 == room_ ? 0 : fill_place_ + 1;
  store_release(filled_, filled_ + 1);
  store_release(came_, came_ + 1);
}

RowRing::Next RowRing::next() const {
  // In the order opposite to that in which they are written: of the rows that have come, those that
  // were filled are known then, and the last one is when there is an end.
  const bool was_last = load_acquire(ended_) != 0;
  const uint32_t came = load_acquire(came_);
  const bool is_there = load_acquire(filled_) != emptied_;
  if (is_there && numbers_[empty_place_] == passed_) return Next::row;
  // A row that was passed may not have been counted yet.
  const bool is_behind = static_cast<int32_t>(came - passed_) > 0;
  if (is_there || is_behind) return Next::lost;
  return was_last ? Next::end : Next::nothing;
}

void RowRing::pass() {
  const bool is_row = load_acquire(filled_) != emptied_ && numbers_[empty_place_] == passed_;
  ++passed_;
  if (!is_row) return;
  empty_place_ = empty_place_ + 1 == room_ ? 0 : empty_place_ + 1;
  store_release(emptied_, emptied_ + 1);
}

}  // namespace discmc
