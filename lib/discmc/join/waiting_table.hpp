// A fixed-capacity hash table with open addressing, for chains that wait for a partner at a place.
// An entry lies within `window` buckets of its key's own bucket, or is not in the table. So a
// removed entry needs no tombstone, a full window is a result ("no room"), and every call has a
// bounded cost for all keys.
#ifndef DISCMC_JOIN_WAITING_TABLE_HPP
#define DISCMC_JOIN_WAITING_TABLE_HPP

#include <discmc/base/checks.hpp>
#include <discmc/lattice.hpp>

namespace discmc::detail::join {

/// The place where a chain waits.
struct WaitingKey {
  Vertex vertex;
  Incidence incidence;
  uint8_t kind;  ///< a direction, or another number defined by the owner of the table
};

constexpr bool operator==(const WaitingKey& a, const WaitingKey& b) {
  return a.vertex == b.vertex && a.incidence == b.incidence && a.kind == b.kind;
}

/// The keys are stored with the chains. A bucket contains the hash of a key, and a value other than
/// 0 that leads to the chain. Owner: the arena, of the buckets.
class WaitingTable {
 public:
  static constexpr uint32_t window = 64;  ///< the bound on probes of every call
  static constexpr uint32_t none = 0;

  /// The buckets for a number of entries: less than one of 10^12 windows is full.
  static constexpr uint32_t buckets_for(uint32_t entries) { return 3 * entries; }

  static constexpr uint32_t hash_of(const WaitingKey& key) {
    const uint32_t words[] = {
        static_cast<uint32_t>(key.vertex.x), static_cast<uint32_t>(key.vertex.y),
        static_cast<uint32_t>(key.vertex.z), uint32_t{key.incidence} << 8 | key.kind};
    uint32_t hash = 0;
    for (const uint32_t word : words) {
      // An odd constant near 2^32 over the golden ratio.
      hash = (hash ^ word) * 0x9E3779B1U;
      hash ^= hash >> 15;
    }
    return hash * 0x9E3779B1U;
  }

  /// Call clear() before using it. Limit: buckets >= 1.
  void start(uint32_t* hashes, uint32_t* values, uint32_t buckets) {
    DISCMC_LIMIT(buckets >= 1);
    hashes_ = hashes;
    values_ = values;
    buckets_ = buckets;
  }

  /// Empties the table. Cost: writes all values once.
  void clear() {
    for (uint32_t i = 0; i < buckets_; ++i) values_[i] = none;
  }

  /// The value under a key, or `none`. has_key(value, key): whether the value leads to the key.
  template <class HasKey>
  uint32_t find(const WaitingKey& key, HasKey has_key) const {
    const uint32_t hash = hash_of(key);
    const uint32_t bucket = first_bucket(hash, [&](uint32_t i) {
      return hashes_[i] == hash && values_[i] != none && has_key(values_[i], key);
    });
    return bucket == buckets_ ? none : values_[bucket];
  }

  /// Inserts a value under a key that is not in the table. Returns false if the key's window is
  /// full; then nothing has changed.
  bool insert(const WaitingKey& key, uint32_t value) {
    const uint32_t hash = hash_of(key);
    const uint32_t bucket = first_bucket(hash, [this](uint32_t i) { return values_[i] == none; });
    if (bucket == buckets_) return false;
    hashes_[bucket] = hash;
    values_[bucket] = value;
    return true;
  }

  /// Replaces a value in the table under the key by another one.
  void replace(const WaitingKey& key, uint32_t value, uint32_t other) {
    const uint32_t hash = hash_of(key);
    const uint32_t bucket =
        first_bucket(hash, [&](uint32_t i) { return hashes_[i] == hash && values_[i] == value; });
    if (bucket != buckets_) values_[bucket] = other;
  }

  /// Removes a value that is in the table under the key.
  void remove(const WaitingKey& key, uint32_t value) { replace(key, value, none); }

 private:
  // The first bucket in the hash's window for which is_right(), or buckets_ if there is none.
  template <class IsRight>
  uint32_t first_bucket(uint32_t hash, IsRight is_right) const {
    uint32_t bucket = static_cast<uint32_t>(uint64_t{hash} * buckets_ >> 32);
    for (uint32_t probes = buckets_ < window ? buckets_ : window; probes > 0; --probes) {
      if (is_right(bucket)) return bucket;
      if (++bucket == buckets_) bucket = 0;
    }
    return buckets_;
  }

  uint32_t* hashes_ = nullptr;
  uint32_t* values_ = nullptr;
  uint32_t buckets_ = 0;
};

}  // namespace discmc::detail::join

#endif
