// Lattice positions, numbered.
#ifndef DISCMC_COMMAND_MESHES_VERTEX_NUMBERS_HPP
#define DISCMC_COMMAND_MESHES_VERTEX_NUMBERS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <discmc/lattice.hpp>

namespace discmc::host {

/// Gives positions numbers from zero on, in the order in which they come. Hash tables with open
/// addressing, half full at most, one for every few slices: polygons come by slices, and what is
/// looked up next is mostly where the last was, in memory that is at hand.
class VertexNumbers {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  VertexNumbers() : tables_(table_count) {}

  /// The number of a position, a new one where it has none.
  std::uint32_t add(const Vertex& position) {
    Table& table = tables_[table_of(position)];
    if (2 * table.used >= table.slots.size()) grow(table);
    std::uint32_t& slot = table.slots[slot_of(table, position)];
    if (slot != none) return slot;
    slot = static_cast<std::uint32_t>(positions_.size());
    positions_.push_back(position);
    ++table.used;
    return slot;
  }

  /// The number of a position, or none.
  std::uint32_t find(const Vertex& position) const {
    const Table& table = tables_[table_of(position)];
    return table.slots.empty() ? none : table.slots[slot_of(table, position)];
  }

  /// By their numbers.
  const std::vector<Vertex>& positions() const { return positions_; }

 private:
  static constexpr std::size_t table_count = 1024;

  struct Table {
    std::vector<std::uint32_t> slots;  // numbers; a power of two
    std::size_t used = 0;
  };

  // Slices far apart may share a table.
  static std::size_t table_of(const Vertex& position) {
    constexpr int half_steps = 3;  // to the power of two
    return static_cast<std::uint32_t>(position.z >> half_steps) % table_count;
  }

  // Where the position is, or would be.
  std::size_t slot_of(const Table& table, const Vertex& position) const {
    const std::size_t mask = table.slots.size() - 1;
    std::size_t slot = hash(position) & mask;
    while (table.slots[slot] != none && positions_[table.slots[slot]] != position)
      slot = (slot + 1) & mask;
    return slot;
  }

  static std::uint64_t hash(const Vertex& position) {
    std::uint64_t mixed = 0;
    for (const std::int32_t coordinate : {position.x, position.y, position.z})
      mixed = (mixed ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B97F4A7C15u;
    return mixed >> 32;
  }

  void grow(Table& table) const {
    constexpr std::size_t least = 64;
    const std::vector<std::uint32_t> before = std::move(table.slots);
    table.slots.assign(std::max(least, 2 * before.size()), none);
    for (const std::uint32_t number : before)
      if (number != none) table.slots[slot_of(table, positions_[number])] = number;
  }

  std::vector<Table> tables_;
  std::vector<Vertex> positions_;
};

}  // namespace discmc::host

#endif
