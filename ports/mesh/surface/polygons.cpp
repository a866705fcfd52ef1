#include "polygons.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace discmc::meshing {
namespace {

struct Key {
  std::array<std::uint32_t, 4> digits;  // the least significant one first
  std::uint32_t place;
};

// Keeps the order of equal digits. Bits that are the same in all keys take no pass.
void sort_by_digit(std::vector<Key>& keys, std::vector<Key>& sorted, std::size_t digit) {
  constexpr std::uint32_t bits = 11;
  std::uint32_t differing = 0;
  for (const Key& key : keys) differing |= key.digits[digit] ^ keys[0].digits[digit];
  for (std::uint32_t shift = 0; shift < 32; shift += bits) {
    const auto part = [&](const Key& key) {
      return key.digits[digit] >> shift & ((std::uint32_t{1} << bits) - 1);
    };
    if ((differing >> shift & ((std::uint32_t{1} << bits) - 1)) == 0) continue;
    std::array<std::uint32_t, (std::size_t{1} << bits) + 1> begins{};
    for (const Key& key : keys) ++begins[part(key) + 1];
    for (std::size_t i = 1; i < begins.size(); ++i) begins[i] += begins[i - 1];
    sorted.resize(keys.size());
    for (const Key& key : keys) sorted[begins[part(key)]++] = key;
    keys.swap(sorted);
  }
}

// In the order of signed numbers.
std::uint32_t digit_of(std::int32_t coordinate) {
  return static_cast<std::uint32_t>(coordinate) ^ 0x80000000u;
}

}  // namespace

void Polygons::sort() {
  std::vector<Key> keys, sorted;
  keys.reserve(records_.size());
  for (const Record& record : records_) {
    const auto place = static_cast<std::uint32_t>(keys.size());
    const std::uint32_t begin = ring_begins_[record.first_ring];
    if (record.rings == 0 || begin == ring_begins_[record.first_ring + 1]) {
      keys.push_back({{record.incidence, 0, 0, 0}, place});
      continue;
    }
    const Vertex& first = corners_[begin];
    keys.push_back(
        {{record.incidence, digit_of(first.x), digit_of(first.y), digit_of(first.z)}, place});
  }
  for (std::size_t digit = 0; digit < 4; ++digit) sort_by_digit(keys, sorted, digit);
  Array<Record> in_order;
  for (std::size_t i = 0; i < keys.size();) {
    const std::size_t first = in_order.size();
    for (const auto& digits = keys[i].digits; i < keys.size() && keys[i].digits == digits; ++i)
      in_order.push_back(records_[keys[i].place]);
    if (in_order.size() > first + 1)
      std::stable_sort(
          in_order.begin() + first, in_order.end(),
          [this](const Record& a, const Record& b) { return has_corners_before(a, b); });
  }
  records_ = std::move(in_order);
}

bool Polygons::has_corners_before(const Record& a, const Record& b) const {
  const auto begin_of = [this](const Record& record) {
    return corners_.begin() + ring_begins_[record.first_ring];
  };
  const auto end_of = [this](const Record& record) {
    return corners_.begin() + ring_begins_[record.first_ring + record.rings];
  };
  return std::lexicographical_compare(begin_of(a), end_of(a), begin_of(b), end_of(b), precedes);
}

}  // namespace discmc::meshing
