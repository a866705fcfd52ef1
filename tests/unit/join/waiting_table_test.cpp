// The joiner's hash table: bounded windows, compared with a map.
#include <discmc/join/waiting_table.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::detail::join;
using test::Chance;

namespace {

// A table in memory of exactly its size with arbitrary contents, and the keys of its values.
class Table {
 public:
  explicit Table(uint32_t buckets) : hashes_(buckets, 0xA5A5A5A5), values_(buckets, 0x5A5A5A5A) {
    table_.start(hashes_.data(), values_.data(), buckets);
    table_.clear();
  }

  bool insert(const WaitingKey& key) {
    keys_.push_back(key);
    if (table_.insert(key, static_cast<uint32_t>(keys_.size()))) return true;
    keys_.pop_back();
    return false;
  }
  /// The number of values inserted so far when the key was inserted, or 0.
  uint32_t find(const WaitingKey& key) const {
    return table_.find(key, [this](uint32_t value, const WaitingKey& wanted) {
      return keys_.at(value - 1) == wanted;
    });
  }
  void remove(const WaitingKey& key) { table_.remove(key, find(key)); }

  WaitingTable& table() { return table_; }

 private:
  std::vector<uint32_t> hashes_, values_;
  std::vector<WaitingKey> keys_;
  WaitingTable table_;
};

// Returns a key for any value.
bool any_value(uint32_t, const WaitingKey&) {
  return true;
}

// Neighbouring keys, like those of the ends of chains.
WaitingKey key_at(uint32_t i) {
  const auto number = static_cast<int32_t>(i);
  return {{number % 37, number / 37 % 41, number / 1517},
          static_cast<Incidence>(i % 13),
          static_cast<uint8_t>(i % 8)};
}

}  // namespace

TEST_CASE("a table entry is found by its key until removed") {
  Table table(30);
  CHECK(table.find(key_at(1)) == 0);
  CHECK(table.insert(key_at(1)));
  CHECK(table.insert(key_at(2)));
  CHECK(table.find(key_at(1)) == 1);
  CHECK(table.find(key_at(2)) == 2);
  table.remove(key_at(1));
  CHECK(table.find(key_at(1)) == 0);
  CHECK(table.find(key_at(2)) == 2);
  table.table().clear();
  CHECK(table.find(key_at(2)) == 0);
}

TEST_CASE("the hash and the comparison of a key depend on every member") {
  const WaitingKey key{{1, 2, 3}, 4, 5};
  Table table(100);
  REQUIRE(table.insert(key));
  for (const WaitingKey& other : {WaitingKey{{0, 2, 3}, 4, 5},
                                  {{1, 0, 3}, 4, 5},
                                  {{1, 2, 0}, 4, 5},
                                  {{1, 2, 3}, 0, 5},
                                  {{1, 2, 3}, 4, 0},
                                  {{2, 1, 3}, 4, 5},
                                  {{1, 2, 3}, 5, 4}}) {
    CHECK(WaitingTable::hash_of(other) != WaitingTable::hash_of(key));
    CHECK(table.find(other) == 0);
    CHECK_FALSE(key == other);
  }
}

TEST_CASE("replace() changes only the entry of its key, even if another entry has the same value") {
  std::vector<uint32_t> hashes(8), values(8);
  WaitingTable table;
  table.start(hashes.data(), values.data(), 8);
  table.clear();
  for (uint32_t i = 1; i < 200; ++i) {
    REQUIRE(table.insert(key_at(0), 7));
    REQUIRE(table.insert(key_at(i), 7));
    table.replace(key_at(i), 7, 8);
    CHECK(table.find(key_at(0), any_value) == 7);
    CHECK(table.find(key_at(i), any_value) == 8);
    table.remove(key_at(i), 8);
    CHECK(table.find(key_at(0), any_value) == 7);
    CHECK(table.find(key_at(i), any_value) == 0);
    table.remove(key_at(0), 7);
  }
}

TEST_CASE("a full table refuses an insertion and keeps its entries") {
  for (const uint32_t buckets : {1U, 2U, 63U, 64U}) {
    Table table(buckets);
    for (uint32_t i = 0; i < buckets; ++i) CHECK(table.insert(key_at(i)));
    CHECK_FALSE(table.insert(key_at(buckets)));
    for (uint32_t i = 0; i < buckets; ++i) CHECK(table.find(key_at(i)) == i + 1);
    table.remove(key_at(0));
    CHECK(table.insert(key_at(buckets)));
    CHECK(table.find(key_at(buckets)) != 0);
  }
}

TEST_CASE("a full window refuses an insertion although the table has room, and keeps its entries") {
  constexpr uint32_t buckets = 1000;
  Table table(buckets);
  uint32_t refused = 0;
  std::vector<WaitingKey> kept;
  for (uint32_t i = 0; i < buckets; ++i) {
    if (table.insert(key_at(i)))
      kept.push_back(key_at(i));
    else
      ++refused;
  }
  CHECK(refused > 0);
  CHECK(refused < buckets / 10);
  for (const WaitingKey& key : kept) CHECK(table.find(key) != 0);
}

TEST_CASE("buckets_for() provides enough buckets for the given number of entries") {
  for (const uint32_t entries : {2U, 10U, 30U, 1000U, 100000U}) {
    Table table(WaitingTable::buckets_for(entries));
    for (uint32_t i = 0; i < entries; ++i) REQUIRE(table.insert(key_at(i)));
  }
}

TEST_CASE("the waiting table equals a list under random insertions and removals") {
  Chance chance(1);
  for (const uint32_t buckets : {1U, 7U, 64U, 65U, 300U}) {
    Table table(buckets);
    std::vector<WaitingKey> model;
    for (int i = 0; i < 20000; ++i) {
      const WaitingKey key = key_at(chance.below(2 * buckets));
      const auto known = std::find(model.begin(), model.end(), key);
      REQUIRE((table.find(key) != 0) == (known != model.end()));
      if (known != model.end()) {
        table.remove(key);
        model.erase(known);
      } else if (table.insert(key)) {
        model.push_back(key);
      }
    }
  }
}

TEST_CASE("replace() changes only the entry with the given value among several entries of a key") {
  Table table(30);
  const WaitingKey key = key_at(5);
  REQUIRE(table.table().insert(key, 1));
  REQUIRE(table.table().insert(key, 2));
  table.table().replace(key, 2, 3);
  CHECK(table.table().find(key, any_value) == 1);
  table.table().remove(key, 1);
  CHECK(table.table().find(key, any_value) == 3);
  table.table().remove(key, 1);  // is missing
  CHECK(table.table().find(key, any_value) == 3);
}

TEST_CASE("a value is not found under another key with the same hash") {
  Table table(30);
  REQUIRE(table.table().insert(key_at(5), 1));
  CHECK(table.table().find(key_at(5), [](uint32_t, const WaitingKey&) { return false; }) == 0);
}
