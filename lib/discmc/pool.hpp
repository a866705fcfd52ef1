// A pool of records with a free list through their first member.
#ifndef DISCMC_POOL_HPP
#define DISCMC_POOL_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// What stands for no record. Records are counted from 1, so that memory that is all zero names
/// nothing, and the test costs one instruction.
constexpr uint8_t no_record = 0;

/// The pointer that makes `first` the array's element 1. There is no element 0 behind it.
template <class T>
T* counted_from_one(T* first) {
  return reinterpret_cast<T*>(reinterpret_cast<uintptr_t>(first) - sizeof(T));
}

/// Keeps account of which records of an array are in use, whatever they are: apart from Pool, so
/// that there is one copy of it for all of them. A record begins with an Index, which names the
/// next free one while it is not in use.
template <class Index>
class RecordAccount {
 public:
  /// Gives all records back at once and forgets the high-water mark.
  void clear() {
    free_ = no_record;
    fresh_ = 0;
    available_ = capacity_;
  }

  /// Forgets where the records lie, until start().
  void forget_addresses() { records_ = nullptr; }

  uint32_t capacity() const { return capacity_; }
  /// Records that may be taken; those in use, and reserved.
  uint32_t available() const { return available_; }
  uint32_t in_use() const { return capacity_ - available_; }
  /// The most that have been in use at once, those reserved not counted.
  uint32_t high_water() const { return fresh_; }

  /// Sets records aside, whichever they will be, until they are released. Limit: so many are
  /// available().
  void reserve(uint32_t count = 1) { available_ -= count; }
  void release(uint32_t count = 1) { available_ += count; }

  /// The first of so many records side by side that have never been taken, or no_record when there
  /// are not so many. Each is given back alone.
  Index take_fresh(uint32_t count) {
    if (count > available_ || count > capacity_ - fresh_) return no_record;
    const auto first = static_cast<Index>(fresh_ + 1);
    available_ -= count;
    fresh_ += count;
    return first;
  }

 protected:
  Index take(uint32_t record_bytes) {
    if (available_ == 0) return no_record;
    --available_;
    if (free_ == no_record) return static_cast<Index>(++fresh_);
    const Index index = free_;
    free_ = next(index, record_bytes);
    return index;
  }

  void give(Index index, uint32_t record_bytes) {
    next(index, record_bytes) = free_;
    free_ = index;
    ++available_;
  }

  uint8_t* records_ = nullptr;  // counted from one
  uint32_t capacity_ = 0;

 private:
  Index& next(Index index, uint32_t record_bytes) {
    return *reinterpret_cast<Index*>(records_ + size_t{index} * record_bytes);
  }

  uint32_t available_ = 0;
  uint32_t fresh_ = 0;  // records after this one have never been taken
  Index free_ = no_record;
};

/// Records named by index, from 1 on. Which index a record gets depends on nothing but the order of
/// the calls. Record: trivial, begins with an Index. Owner: the records lie in the arena.
/// Cost of take() and give(): a few instructions.
template <class Record, class Index>
class Pool : public RecordAccount<Index> {
 public:
  /// Says where the records lie. Call clear() before the first is taken.
  void start(Record* records, uint32_t capacity) {
    this->records_ = reinterpret_cast<uint8_t*>(counted_from_one(records));
    this->capacity_ = capacity;
  }

  /// A record, its members undefined, or no_record when all are in use.
  Index take() { return RecordAccount<Index>::take(sizeof(Record)); }
  void give(Index index) { RecordAccount<Index>::give(index, sizeof(Record)); }

  Record& operator[](Index index) { return reinterpret_cast<Record*>(this->records_)[index]; }
  const Record& operator[](Index index) const {
    return reinterpret_cast<const Record*>(this->records_)[index];
  }
};

}  // namespace discmc

#endif
