// Lattice positions, numbered.
#ifndef DISCMC_MESH_MESHES_VERTEX_NUMBERS_HPP
#define DISCMC_MESH_MESHES_VERTEX_NUMBERS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <discmc/lattice.hpp>

namespace discmc::meshing {

/// Gives positions numbers from zero on, in the order in which they come. Hash tables with open
/// addressing, half full at most, one for every few slices: polygons come by slices, and what is
/// looked up next is mostly where the last was, in memory that is at hand.
class VertexNumbers {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  VertexNumbers() : tables_(table_count) {}

  /// The number of a position, a new one where it has none.
  std::uint32_t add(const Vertex& position) {
    const auto next = static_cast<std::uint32_t>(positions_.size());
    const std::uint32_t number = tables_[table_of(position)].add(position, next, positions_);
    if (number == next) positions_.push_back(position);
    return number;
  }

  /// The numbers of many positions, as add() of one after the other gives them, by `jobs` threads
  /// at once. Limit: nothing has a number yet.
  std::vector<std::uint32_t> add_all(const std::vector<Vertex>& positions, unsigned jobs);

  /// The number of a position, or none.
  std::uint32_t find(const Vertex& position) const {
    return tables_[table_of(position)].find(position, positions_);
  }

  /// By their numbers.
  const std::vector<Vertex>& positions() const& { return positions_; }
  std::vector<Vertex> positions() && { return std::move(positions_); }

 private:
  static constexpr std::size_t table_count = 1024;

  class Table {
   public:
    bool empty() const { return slots_.empty(); }
    // next: the number of a new one. positions: by their numbers.
    std::uint32_t add(const Vertex& position, std::uint32_t next,
                      const std::vector<Vertex>& positions) {
      if (2 * used_ >= slots_.size()) grow(positions);
      std::uint32_t& slot = slots_[slot_of(position, positions)];
      if (slot != none) return slot;
      ++used_;
      return slot = next;
    }
    std::uint32_t find(const Vertex& position, const std::vector<Vertex>& positions) const {
      return empty() ? none : slots_[slot_of(position, positions)];
    }
    // numbers: by those that there are.
    void renumber(const std::vector<std::uint32_t>& numbers) {
      for (std::uint32_t& slot : slots_)
        if (slot != none) slot = numbers[slot];
    }

   private:
    // The slot of the position, occupied or free.
    std::size_t slot_of(const Vertex& position, const std::vector<Vertex>& positions) const {
      const std::size_t mask = slots_.size() - 1;
      std::size_t slot = hash(position) & mask;
      while (slots_[slot] != none && positions[slots_[slot]] != position) slot = (slot + 1) & mask;
      return slot;
    }
    void grow(const std::vector<Vertex>& positions) {
      constexpr std::size_t least = 64;
      const std::vector<std::uint32_t> before = std::move(slots_);
      slots_.assign(std::max(least, 2 * before.size()), none);
      for (const std::uint32_t number : before)
        if (number != none) slots_[slot_of(positions[number], positions)] = number;
    }

    std::vector<std::uint32_t> slots_;  // numbers; a power of two
    std::size_t used_ = 0;
  };

  // Adds those of another. Returns their numbers, by those that they have there.
  std::vector<std::uint32_t> join(VertexNumbers&& other);

  // Slices far apart may share a table.
  static std::size_t table_of(const Vertex& position) {
    constexpr int half_steps = 3;  // to the power of two
    return static_cast<std::uint32_t>(position.z >> half_steps) % table_count;
  }

  static std::uint64_t hash(const Vertex& position) {
    std::uint64_t mixed = 0;
    for (const std::int32_t coordinate : {position.x, position.y, position.z})
      mixed = (mixed ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B97F4A7C15u;
    return mixed >> 32;
  }

  std::vector<Table> tables_;
  std::vector<Vertex> positions_;
};

}  // namespace discmc::meshing

#endif
