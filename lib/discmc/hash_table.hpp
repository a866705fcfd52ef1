// A fixed-capacity hash table with open addressing.
//
// Probing is bounded by a window: an entry lies within `window` slots of its key's own slot, or is
// not there. So a removed entry needs no tombstone, a full window is a result ("no room"), and the
// cost of every call is bounded whatever the keys. Clearing is one addition: a slot holds its key
// plus the epoch times the range of keys, and is empty when that lies outside the current epoch.
#ifndef DISCMC_HASH_TABLE_HPP
#define DISCMC_HASH_TABLE_HPP

#include <discmc/pool.hpp>

namespace discmc {

/// Maps keys below a fixed range to indices. With as many slots as keys each key has its own slot,
/// and there is always room. Owner: the slots lie in the arena.
template <class Index>
class HashTable {
 public:
  static constexpr uint32_t window = 32;  ///< the bound on probes of every call

  /// A slot's key and value stand in two arrays, so that a slot is 6 bytes with 16-bit indices.
  /// Limit: slots >= 1, 1 <= range < 2^31. Cost: writes all slots once.
  void start(uint32_t* stamps, Index* values, uint32_t slots, uint32_t range) {
    stamps_ = stamps;
    values_ = values;
    slots_ = slots;
    range_ = range;
    wipe();
  }

  /// Empties the table. Cost: one addition, except that all slots are written once in every
  /// 2^32 / range calls, when the epochs are used up.
  void clear() {
    in_use_ = 0;
    high_water_ = 0;
    if (epoch_ > UINT32_MAX - 2 * range_ + 1)
      wipe();
    else
      epoch_ += range_;
  }

  /// Remembers a value under a key that is not in the table. False when the key's window is full;
  /// then nothing has changed.
  bool insert(uint32_t key, Index value) {
    uint32_t slot = first_slot(key);
    for (uint32_t probes = probe_count(); probes > 0; --probes, slot = after(slot)) {
      if (is_used(slot)) continue;
      stamps_[slot] = epoch_ + key;
      values_[slot] = value;
      if (++in_use_ > high_water_) high_water_ = in_use_;
      return true;
    }
    return false;
  }

  /// Removes a key and returns its value, or no_record when it is not in the table.
  Index take(uint32_t key) {
    uint32_t slot = first_slot(key);
    for (uint32_t probes = probe_count(); probes > 0; --probes, slot = after(slot)) {
      if (stamps_[slot] != epoch_ + key) continue;
      stamps_[slot] = empty;
      --in_use_;
      return values_[slot];
    }
    return no_record;
  }

  uint32_t capacity() const { return slots_; }
  uint32_t in_use() const { return in_use_; }
  uint32_t high_water() const { return high_water_; }

 private:
  static constexpr uint32_t empty = 0;  // epochs start at 1

  void wipe() {
    for (uint32_t i = 0; i < slots_; ++i) stamps_[i] = empty;
    epoch_ = 1;
    in_use_ = 0;
    high_water_ = 0;
  }

  bool is_used(uint32_t slot) const { return stamps_[slot] - epoch_ < range_; }

  // Multiplication by an odd constant near 2^32 over the golden ratio spreads neighbouring keys
  // (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
  uint32_t first_slot(uint32_t key) const {
    if (slots_ >= range_) return key;
    const uint32_t spread = key * 0x9E3779B1U;
    return static_cast<uint32_t>(uint64_t{spread} * slots_ >> 32);
  }

  uint32_t after(uint32_t slot) const { return slot + 1 < slots_ ? slot + 1 : 0; }

  uint32_t probe_count() const {
    if (slots_ >= range_) return 1;
    return slots_ < window ? slots_ : window;
  }

  uint32_t* stamps_ = nullptr;
  Index* values_ = nullptr;
  uint32_t slots_ = 0;
  uint32_t range_ = 0;
  uint32_t epoch_ = 0;
  uint32_t in_use_ = 0;
  uint32_t high_water_ = 0;
};

}  // namespace discmc

#endif
