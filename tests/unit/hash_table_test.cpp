// The hash table: bounded windows, and std::unordered_map to compare with.
#include <doctest/doctest.h>
#include <discmc/hash_table.hpp>

#include <algorithm>
#include <unordered_map>
#include <vector>

using namespace discmc;

namespace {

// A table in memory of exactly its size, filled with what an arena may hold.
template <class Index>
class Table : public HashTable<Index> {
 public:
  Table(uint32_t slots, uint32_t range) : keys_(slots, 0xA5A5A5A5), values_(slots, 0x5A5A) {
    this->start(keys_.data(), values_.data(), slots, range);
    this->clear();
  }

  /// The slots as they are, to forge entries where the table itself would put none.
  std::vector<uint32_t>& keys() { return keys_; }

 private:
  std::vector<uint32_t> keys_;
  std::vector<Index> values_;
};

uint32_t next_random(uint32_t& state) {
  state = state * 1664525 + 1013904223;
  return state >> 8;
}

// Where in an empty table a key has gone: the begin of its window.
uint32_t slot_of(Table<uint16_t>& table, uint32_t key) {
  const auto place = std::find(table.keys().begin(), table.keys().end(), key + 1);
  return static_cast<uint32_t>(place - table.keys().begin());
}

// Keys whose windows begin at one slot: what an adversary would choose who knows the hash.
std::vector<uint32_t> colliding_keys(uint32_t slots, uint32_t range, size_t count) {
  std::vector<uint32_t> found;
  uint32_t first = 0;
  for (uint32_t key = range - 1; found.size() < count; --key) {
    Table<uint16_t> table(slots, range);
    REQUIRE(table.insert(key, 1));
    const uint32_t slot = slot_of(table, key);
    if (found.empty()) first = slot;
    if (slot == first) found.push_back(key);
  }
  return found;
}

// The frontier clears rarely; here it happens often.
template <class Index>
void check_random_operations(uint32_t slots, uint32_t range, uint32_t seed) {
  Table<Index> table(slots, range);
  std::unordered_map<uint32_t, Index> model;
  uint32_t refused = 0;
  for (uint32_t i = 0; i < 30000; ++i) {
    const uint32_t roll = next_random(seed) % 1000;
    const uint32_t key = next_random(seed) % range;
    const auto value = static_cast<Index>(1 + next_random(seed) % 0xFFFF);
    if (roll < 2) {
      table.clear();
      model.clear();
    } else if (roll < 500 && model.count(key) == 0) {
      if (table.insert(key, value))
        model.emplace(key, value);
      else
        ++refused;
    } else {
      const auto known = model.find(key);
      const Index expected = known == model.end() ? no_record : known->second;
      REQUIRE(table.take(key) == expected);
      if (known != model.end()) model.erase(known);
    }
    REQUIRE(table.in_use() == model.size());
    REQUIRE(table.in_use() <= table.high_water());
  }
  for (const auto& [key, value] : model) CHECK(table.take(key) == value);
  CHECK(table.in_use() == 0);
  if (slots >= range) CHECK(refused == 0);
}

}  // namespace

TEST_CASE("what was inserted is taken once") {
  Table<uint16_t> table(10, 100);
  CHECK(table.take(7) == no_record);
  CHECK(table.insert(7, 70));
  CHECK(table.insert(0, 1));
  CHECK(table.insert(99, 2));
  CHECK(table.in_use() == 3);
  CHECK(table.take(7) == 70);
  CHECK(table.take(7) == no_record);
  CHECK(table.take(0) == 1);
  CHECK(table.take(99) == 2);
  CHECK(table.in_use() == 0);
  CHECK(table.high_water() == 3);
}

TEST_CASE("the high-water mark is of the most at once, not of the last") {
  Table<uint16_t> table(10, 100);
  for (uint32_t key = 0; key < 4; ++key) CHECK(table.insert(key, uint16_t{1}));
  for (uint32_t key = 0; key < 3; ++key) CHECK(table.take(key) == 1);
  CHECK(table.insert(50, uint16_t{1}));
  CHECK(table.in_use() == 2);
  CHECK(table.high_water() == 4);
}

TEST_CASE("whatever the memory held, a cleared table is empty") {
  for (const uint32_t filling : {0U, 1U, 17U, 0x80000000U, 0xFFFFFFFFU}) {
    std::vector<uint32_t> keys(16, filling);
    std::vector<uint16_t> values(16, 3);
    HashTable<uint16_t> table;
    table.start(keys.data(), values.data(), 16, 40);
    table.clear();
    for (uint32_t key = 0; key < 40; ++key) CHECK(table.take(key) == no_record);
    CHECK(table.in_use() == 0);
  }
}

TEST_CASE("a full table is a result, and changes nothing") {
  for (const uint32_t slots : {1U, 2U, 31U, 32U}) {
    Table<uint16_t> table(slots, 1000);
    for (uint32_t key = 0; key < slots; ++key) CHECK(table.insert(3 * key, uint16_t{5}));
    CHECK_FALSE(table.insert(999, 6));
    CHECK(table.in_use() == slots);
    CHECK(table.take(999) == no_record);
    for (uint32_t key = 0; key < slots; ++key) CHECK(table.take(3 * key) == 5);
    CHECK(table.insert(999, 6));
    CHECK(table.take(999) == 6);
  }
}

TEST_CASE("a full window is a result although the table has room, and no entry is lost") {
  constexpr uint32_t slots = 400;
  Table<uint32_t> table(slots, 1000000);
  std::vector<uint32_t> kept;
  uint32_t refused = 0;
  for (uint32_t key = 0; table.in_use() < slots && key < 100000; ++key) {
    if (!table.insert(key, key))
      ++refused;
    else
      kept.push_back(key);
    if (refused == 1 && kept.size() + 1 == key + 1) CHECK(table.in_use() < slots);
  }
  CHECK(refused > 0);
  CHECK(kept.size() == table.in_use());
  for (const uint32_t key : kept) CHECK(table.take(key) == key);
}

TEST_CASE("the window goes round the end of the table") {
  // With a window as long as the table every slot can be reached from every key.
  Table<uint16_t> table(HashTable<uint16_t>::window, 1000000);
  for (uint32_t key = 0; key < 32; ++key)
    CHECK(table.insert(999999 - 31337 * key, static_cast<uint16_t>(key)));
  for (uint32_t key = 0; key < 32; ++key) CHECK(table.take(999999 - 31337 * key) == key);
}

TEST_CASE("no key is looked for beyond its window, wherever in the table that begins") {
  constexpr uint32_t window = HashTable<uint16_t>::window;
  for (const uint32_t slots : {window + 1, 40U, 257U})
    for (uint32_t key = 0; key < 999; key += 111) {
      Table<uint16_t> table(slots, 1000);
      REQUIRE(table.insert(key, 1));
      const uint32_t first = slot_of(table, key);
      CHECK(table.take(key) == 1);
      for (uint32_t distance = 0; distance < slots; ++distance) {
        CAPTURE(distance);
        table.clear();
        table.keys()[(first + distance) % slots] = key + 1;  // forged
        CHECK((table.take(key) != no_record) == (distance < window));
      }
    }
}

TEST_CASE("of keys that all collide a table takes a window full, and not one more") {
  constexpr uint32_t window = HashTable<uint16_t>::window;
  constexpr uint32_t slots = 257;
  const std::vector<uint32_t> keys = colliding_keys(slots, 0x7FFFFFFF, window + 1);
  Table<uint16_t> table(slots, 0x7FFFFFFF);
  for (uint32_t i = 0; i < window; ++i) REQUIRE(table.insert(keys[i], static_cast<uint16_t>(i)));
  CHECK_FALSE(table.insert(keys[window], 99));
  CHECK(table.take(keys[window]) == no_record);
  for (uint32_t i = 1; i < window; ++i) CHECK(table.take(keys[i]) == i);
  CHECK(table.insert(keys[window], 99));
}

TEST_CASE("with a slot for every key there is always room") {
  for (const uint32_t slots : {50U, 51U, 1000U}) {
    Table<uint16_t> table(slots, 50);
    for (int round = 0; round < 3; ++round) {
      for (uint32_t key = 0; key < 50; ++key)
        CHECK(table.insert(key, static_cast<uint16_t>(key + 1)));
      CHECK(table.in_use() == 50);
      if (round == 1)
        table.clear();
      else
        for (uint32_t key = 50; key-- > 0;) CHECK(table.take(key) == key + 1);
      for (uint32_t key = 0; key < 50; ++key) CHECK(table.take(key) == no_record);
    }
  }
}

TEST_CASE("clearing empties the table and forgets the marks") {
  Table<uint16_t> table(20, 60);
  for (int round = 0; round < 1000; ++round) {
    for (uint32_t key = 0; key < 60; key += 7)
      CHECK(table.insert(key, static_cast<uint16_t>(round)));
    CHECK(table.high_water() == 9);
    table.clear();
    CHECK(table.in_use() == 0);
    CHECK(table.high_water() == 0);
    for (uint32_t key = 0; key < 60; ++key) CHECK(table.take(key) == no_record);
  }
}

TEST_CASE("any operations give what std::unordered_map gives") {
  uint32_t seed = 1;
  for (const uint32_t slots : {1U, 5U, 31U, 32U, 33U, 64U, 100U, 1000U})
    for (const uint32_t range : {1U, 4U, 33U, 64U, 200U, 0x30000000U, 0x7FFFFFFFU}) {
      CAPTURE(slots);
      CAPTURE(range);
      check_random_operations<uint16_t>(slots, range, ++seed);
      check_random_operations<uint32_t>(slots, range, ++seed);
    }
}

TEST_CASE("the keys of a real layer fill a table to four fifths without a refusal") {
  // Two keys a cell, in the cells along a curve: as a frontier has them.
  constexpr uint32_t columns = 257;
  Table<uint16_t> table(1250, 2 * columns * columns);
  uint32_t refused = 0;
  for (uint32_t i = 0; i < 500; ++i) {
    const uint32_t row = 20 + i / 3;
    const uint32_t column = 30 + i * i / 1500;
    refused += !table.insert(2 * (row * columns + column) + i % 2, static_cast<uint16_t>(i));
    refused += !table.insert(2 * ((row + 40) * columns + i % 251) + i % 2, uint16_t{1});
  }
  CHECK(refused == 0);
}
