// A fixed-capacity hash table with open addressing.
//
// Probing is bounded by a window: an entry lies within `window` slots of its key's own slot, or is
// not there. So a removed entry needs no tombstone, a full window is a result ("no room"), and the
// cost of every call is bounded whatever the keys.
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
  /// Call clear() before using it. Limit: slots >= 1, range < 2^31.
  void start(uint32_t* keys, Index* values, uint32_t slots, uint32_t range) {
    keys_ = keys;
    values_ = values;
    slots_ = slots;
    range_ = range;
  }

  /// Empties the table. Cost: writes all slots once.
  void clear() {
    for (uint32_t i = 0; i < slots_; ++i) keys_[i] = empty;
    in_use_ = 0;
    high_water_ = 0;
  }

  /// Remembers a value under a key that is not in the table. False when the key's window is full;
  /// then nothing has changed.
  bool insert(uint32_t key, Index value) {
    const uint32_t slot = find(key, empty);
    if (slot == slots_) return false;
    keys_[slot] = kept(key);
    values_[slot] = value;
    if (++in_use_ > high_water_) high_water_ = in_use_;
    return true;
  }

  /// Removes a key and returns its value, or no_record when it is not in the table.
  Index take(uint32_t key) {
    const uint32_t slot = find(key, kept(key));
    if (slot == slots_) return no_record;
    keys_[slot] = empty;
    --in_use_;
    return values_[slot];
  }

  uint32_t capacity() const { return slots_; }
  uint32_t in_use() const { return in_use_; }
  uint32_t high_water() const { return high_water_; }

 private:
  static constexpr uint32_t empty = 0;
  static constexpr uint32_t kept(uint32_t key) { return key + 1; }

  // The first slot of the key's window that holds `wanted`, or slots_ when none does.
  uint32_t find(uint32_t key, uint32_t wanted) const {
    uint32_t slot = first_slot(key);
    for (uint32_t probes = probe_count(); probes > 0; --probes) {
      if (keys_[slot] == wanted) return slot;
      if (++slot == slots_) slot = 0;
    }
    return slots_;
  }

  // Multiplication by an odd constant near 2^32 over the golden ratio spreads neighbouring keys
  // (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
  uint32_t first_slot(uint32_t key) const {
    if (slots_ >= range_) return key;
    const uint32_t spread = key * 0x9E3779B1U;
    return static_cast<uint32_t>(uint64_t{spread} * slots_ >> 32);
  }

  uint32_t probe_count() const {
    if (slots_ >= range_) return 1;
    return slots_ < window ? slots_ : window;
  }

  uint32_t* keys_ = nullptr;
  Index* values_ = nullptr;
  uint32_t slots_ = 0;
  uint32_t range_ = 0;
  uint32_t in_use_ = 0;
  uint32_t high_water_ = 0;
};

}  // namespace discmc

#endif
