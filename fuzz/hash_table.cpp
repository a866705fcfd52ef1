// Fuzz target. The promise: whatever is inserted, taken and cleared, in a table of any size, every
// call comes to what a map says; an entry is refused only when its window may be full, and then
// nothing changes.
//
//   fuzz_hash_table -max_len=400 corpus/hash_table      with libFuzzer
//   fuzz_hash_table corpus/hash_table                   with replay_main.cpp

#include <discmc/hash_table.hpp>
#include <unordered_map>
#include <vector>

#include "input.hpp"
#include "require.hpp"

using namespace discmc;

namespace {

/// A table and a map side by side. The slots lie in heap blocks of exactly their size, filled with
/// what an arena may hold.
template <class Index>
class Pair {
 public:
  Pair(uint32_t slots, uint32_t range)
      : slots_(slots), range_(range), keys_(slots, 0xA5A5A5A5), values_(slots, Index{0x5A5A}) {
    table_.start(keys_.data(), values_.data(), slots, range);
    clear();
  }

  void clear() {
    table_.clear();
    map_.clear();
    high_water_ = 0;
    check_counts();
  }

  // A key that is there already is not to be inserted: it is taken first.
  void insert(uint32_t key, Index value) {
    if (map_.count(key) != 0) take(key);
    if (table_.insert(key, value)) {
      map_.emplace(key, value);
      if (map_.size() > high_water_) high_water_ = map_.size();
    } else {
      require(slots_ < range_, "refused, with a slot for every key");
      const uint32_t window = slots_ < HashTable<Index>::window ? slots_ : HashTable<Index>::window;
      require(map_.size() >= window, "refused, with fewer entries than a window has slots");
    }
    check_counts();
  }

  void take(uint32_t key) {
    const auto known = map_.find(key);
    const Index expected = known == map_.end() ? no_record : known->second;
    require(table_.take(key) == expected, "not the value that was inserted");
    if (known != map_.end()) map_.erase(known);
    check_counts();
  }

  void take_all() {
    while (!map_.empty()) take(map_.begin()->first);
  }

 private:
  void check_counts() const {
    require(table_.capacity() == slots_, "another capacity");
    require(table_.in_use() == map_.size(), "another number of entries");
    require(table_.high_water() == high_water_, "another high-water mark");
  }

  uint32_t slots_;
  uint32_t range_;
  std::vector<uint32_t> keys_;
  std::vector<Index> values_;
  HashTable<Index> table_;
  std::unordered_map<uint32_t, Index> map_;
  size_t high_water_ = 0;
};

/// Keys that a frontier has: in rows, near one another, and now and then anywhere.
uint32_t read_key(Input& input, uint32_t range) {
  const uint32_t key = input.byte();
  return (key < 192 ? key : input.number(UINT32_MAX)) % range;
}

template <class Index>
void check(Input& input, uint32_t slots, uint32_t range) {
  Pair<Index> pair(slots, range);
  for (Index value = 1; !input.is_empty(); ++value) {
    const uint32_t operation = input.byte();
    uint32_t key = read_key(input, range);
    if (operation < 110) pair.insert(key, value);
    if (operation >= 110 && operation < 220) pair.take(key);
    if (operation >= 220 && operation < 250) {
      // A row of keys, which is what fills windows.
      const uint32_t step = 1 + input.byte();
      for (uint32_t count = operation - 210; count > 0; --count) {
        pair.insert(key, value);
        key = static_cast<uint32_t>((uint64_t{key} + step) % range);
      }
    }
    if (operation >= 250 && operation < 253) pair.take_all();
    if (operation >= 253) pair.clear();
  }
  pair.take_all();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  const bool is_wide = input.below(2) != 0;
  const uint32_t slots = 1 + input.byte();
  const uint32_t range = 1 + input.number(0x7FFFFFFE);
  if (is_wide)
    check<uint32_t>(input, slots, range);
  else
    check<uint16_t>(input, slots, range);
  return 0;
}
