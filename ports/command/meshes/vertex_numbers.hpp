// Lattice positions, numbered.
#ifndef DISCMC_COMMAND_MESHES_VERTEX_NUMBERS_HPP
#define DISCMC_COMMAND_MESHES_VERTEX_NUMBERS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/lattice.hpp>

namespace discmc::host {

/// Gives positions numbers from zero on, in the order in which they come. A hash table with open
/// addressing, half full at most.
class VertexNumbers {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  VertexNumbers() : slots_(std::size_t{1} << 10, none) {}

  /// The number of a position, a new one where it has none.
  std::uint32_t add(const Vertex& position) {
    std::uint32_t& slot = slots_[slot_of(position)];
    if (slot != none) return slot;
    const auto number = static_cast<std::uint32_t>(positions_.size());
    slot = number;
    positions_.push_back(position);
    if (2 * positions_.size() > slots_.size()) grow();
    return number;
  }

  /// The number of a position, or none.
  std::uint32_t find(const Vertex& position) const { return slots_[slot_of(position)]; }

  /// By their numbers.
  const std::vector<Vertex>& positions() const { return positions_; }

 private:
  // Where the position is, or would be.
  std::uint64_t slot_of(const Vertex& position) const {
    const std::uint64_t mask = slots_.size() - 1;
    std::uint64_t slot = hash(position) & mask;
    while (slots_[slot] != none && positions_[slots_[slot]] != position) slot = (slot + 1) & mask;
    return slot;
  }

  static std::uint64_t hash(const Vertex& position) {
    std::uint64_t mixed = 0;
    for (const std::int32_t coordinate : {position.x, position.y, position.z})
      mixed = (mixed ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B97F4A7C15u;
    return mixed >> 32;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (std::size_t number = 0; number < positions_.size(); ++number)
      slots_[slot_of(positions_[number])] = static_cast<std::uint32_t>(number);
  }

  std::vector<Vertex> positions_;
  std::vector<std::uint32_t> slots_;  // numbers
};

}  // namespace discmc::host

#endif
