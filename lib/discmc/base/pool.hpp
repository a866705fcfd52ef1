// A pool of slots with a free list through their first member.
#ifndef DISCMC_BASE_POOL_HPP
#define DISCMC_BASE_POOL_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/checks.hpp>
#include <discmc/base/compiler.hpp>

namespace discmc {

/// The index of no slot. Slots count from 1, so all-zero memory refers to no slot, and a comparison
/// with no_slot costs one instruction.
constexpr uint8_t no_slot = 0;

/// Returns the pointer that makes `first` element 1 of the array. Element 0 does not exist.
template <class T>
T* counted_from_one(T* first) {
  return reinterpret_cast<T*>(reinterpret_cast<uintptr_t>(first) - sizeof(T));
}

/// Tracks which slots of an array are in use, independent of their type, so that all pools share
/// one copy of the code. A free slot begins with the Index of the next free slot.
template <class Index>
class SlotAccount {
 public:
  /// Frees all slots, and resets the peak.
  void clear() {
    free_ = no_slot;
    fresh_ = 0;
    available_ = capacity_;
  }

  uint32_t capacity() const { return capacity_; }
  /// available(): the slots that allocate() may still return. in_use(): all others, including
  /// reserved slots.
  uint32_t available() const { return available_; }
  uint32_t in_use() const { return capacity_ - available_; }
  /// The peak: the most slots in use at once, without reserved ones.
  uint32_t peak() const { return fresh_; }

  /// Reserves slots until unreserve(), without choosing them. Limit: at least this many are
  /// available().
  void reserve(uint32_t count = 1) {
    DISCMC_LIMIT(count <= available_);
    available_ -= count;
  }
  void unreserve(uint32_t count = 1) {
    DISCMC_LIMIT(count <= in_use());
    available_ += count;
  }

 protected:
  Index allocate(uint32_t slot_bytes) {
    if (available_ == 0) return no_slot;
    --available_;
    if (free_ == no_slot) {
      const auto fresh = static_cast<Index>(++fresh_);
      DISCMC_LIMIT(fresh_ <= capacity_);
      unpoison(&next(fresh, slot_bytes), slot_bytes);
      return fresh;
    }
    const Index index = free_;
    DISCMC_LIMIT(has(index));
    unpoison(&next(index, slot_bytes), slot_bytes);
    free_ = next(index, slot_bytes);
    return index;
  }

  void release(Index index, uint32_t slot_bytes) {
    DISCMC_LIMIT(has(index) && available_ < capacity_);
    next(index, slot_bytes) = free_;
    free_ = index;
    ++available_;
    poison(&next(index, slot_bytes), slot_bytes);
  }

  /// Whether a slot has ever been allocated.
  DISCMC_ALWAYS_INLINE bool has(Index index) const { return index != no_slot && index <= fresh_; }

  uint8_t* slots_ = nullptr;  // counted from 1
  uint32_t capacity_ = 0;

 private:
  Index& next(Index index, uint32_t slot_bytes) {
    void* const slot = slots_ + size_t{index} * slot_bytes;
    return *static_cast<Index*>(slot);
  }

  uint32_t available_ = 0;
  uint32_t fresh_ = 0;  // slots after this one were never allocated
  Index free_ = no_slot;
};

/// Slots with an index, from 1 on. The index of a slot depends only on the order of the calls.
/// Slot: trivial, begins with an Index. Owner: the slots lie in the arena. Cost of allocate() and
/// release(): a few instructions.
template <class Slot, class Index>
class Pool : public SlotAccount<Index> {
 public:
  /// Sets the address of the slots. Call clear() before the first allocate().
  void start(Slot* slots, uint32_t capacity) {
    this->slots_ = reinterpret_cast<uint8_t*>(counted_from_one(slots));
    this->capacity_ = capacity;
  }

  /// Continues in a larger array, to which the caller has copied the slots up to peak(). Call
  /// unpoison_free() before copying.
  void move_to(Slot* slots, uint32_t capacity) {
    const uint32_t added = capacity - this->capacity_;
    start(slots, capacity);
    this->unreserve(added);
  }

  /// Frees all slots, and resets the peak.
  DISCMC_ALWAYS_INLINE void clear() {
    SlotAccount<Index>::clear();
    if (this->capacity_ > 0)
      poison(this->slots_ + sizeof(Slot), size_t{this->capacity_} * sizeof(Slot));
  }

  /// Returns a slot with undefined members, or no_slot if all are in use.
  Index allocate() { return SlotAccount<Index>::allocate(sizeof(Slot)); }
  /// Frees a slot. Limit: it is in use.
  void release(Index index) { SlotAccount<Index>::release(index, sizeof(Slot)); }

  /// Lets the caller access free slots, too, until they are allocated and freed again: checks.hpp.
  DISCMC_ALWAYS_INLINE void unpoison_free() {
    unpoison(this->slots_ + sizeof(Slot), size_t{this->capacity_} * sizeof(Slot));
  }

  Slot& operator[](Index index) {
    DISCMC_LIMIT(this->has(index));
    void* const slots = this->slots_;
    return static_cast<Slot*>(slots)[index];
  }
  const Slot& operator[](Index index) const {
    DISCMC_LIMIT(this->has(index));
    const void* const slots = this->slots_;
    return static_cast<const Slot*>(slots)[index];
  }
};

}  // namespace discmc

#endif
