// A pool of slots with a free list through their first member.
#ifndef DISCMC_POOL_HPP
#define DISCMC_POOL_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// What stands for no slot. Slots are counted from 1, so that memory that is all zero names
/// nothing, and the test costs one instruction.
constexpr uint8_t no_slot = 0;

/// The pointer that makes `first` the array's element 1. There is no element 0 behind it.
template <class T>
T* counted_from_one(T* first) {
  return reinterpret_cast<T*>(reinterpret_cast<uintptr_t>(first) - sizeof(T));
}

/// Keeps account of which slots of an array are in use, whatever they are: apart from Pool, so
/// that there is one copy of it for all of them. A slot begins with an Index, which names the
/// next free one while it is not in use.
template <class Index>
class SlotAccount {
 public:
  /// Gives all slots back at once and forgets the high-water mark.
  void clear() {
    free_ = no_slot;
    fresh_ = 0;
    available_ = capacity_;
  }

  /// Forgets where the slots lie, until start().
  void forget_addresses() { slots_ = nullptr; }

  uint32_t capacity() const { return capacity_; }
  /// Slots that may be taken; those in use, and reserved.
  uint32_t available() const { return available_; }
  uint32_t in_use() const { return capacity_ - available_; }
  /// The most that have been in use at once, those reserved not counted.
  uint32_t high_water() const { return fresh_; }

  /// Sets slots aside, whichever they will be, until they are released. Limit: so many are
  /// available().
  void reserve(uint32_t count = 1) { available_ -= count; }
  void release(uint32_t count = 1) { available_ += count; }

  /// The first of so many slots side by side that have never been taken, or no_slot when there
  /// are not so many. Each is given back alone.
  Index take_fresh(uint32_t count) {
    if (count > available_ || count > capacity_ - fresh_) return no_slot;
    const auto first = static_cast<Index>(fresh_ + 1);
    available_ -= count;
    fresh_ += count;
    return first;
  }

 protected:
  Index take(uint32_t slot_bytes) {
    if (available_ == 0) return no_slot;
    --available_;
    if (free_ == no_slot) return static_cast<Index>(++fresh_);
    const Index index = free_;
    free_ = next(index, slot_bytes);
    return index;
  }

  void give(Index index, uint32_t slot_bytes) {
    next(index, slot_bytes) = free_;
    free_ = index;
    ++available_;
  }

  uint8_t* slots_ = nullptr;  // counted from one
  uint32_t capacity_ = 0;

 private:
  Index& next(Index index, uint32_t slot_bytes) {
    return *reinterpret_cast<Index*>(slots_ + size_t{index} * slot_bytes);
  }

  uint32_t available_ = 0;
  uint32_t fresh_ = 0;  // slots after this one have never been taken
  Index free_ = no_slot;
};

/// Slots named by index, from 1 on. Which index a slot gets depends on nothing but the order of
/// the calls. Slot: trivial, begins with an Index. Owner: the slots lie in the arena.
/// Cost of take() and give(): a few instructions.
template <class Slot, class Index>
class Pool : public SlotAccount<Index> {
 public:
  /// Says where the slots lie. Call clear() before the first is taken.
  void start(Slot* slots, uint32_t capacity) {
    this->slots_ = reinterpret_cast<uint8_t*>(counted_from_one(slots));
    this->capacity_ = capacity;
  }

  /// A slot, its members undefined, or no_slot when all are in use.
  Index take() { return SlotAccount<Index>::take(sizeof(Slot)); }
  void give(Index index) { SlotAccount<Index>::give(index, sizeof(Slot)); }

  Slot& operator[](Index index) { return reinterpret_cast<Slot*>(this->slots_)[index]; }
  const Slot& operator[](Index index) const {
    return reinterpret_cast<const Slot*>(this->slots_)[index];
  }
};

}  // namespace discmc

#endif
