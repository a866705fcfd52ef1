#include "vertex_numbers.hpp"

#include <algorithm>

#include <discmc/base/compiler.hpp>

namespace discmc::meshing {

VertexNumbers::VertexNumbers(const Polygons& polygons) {
  Block* block = nullptr;  // of the last corner, and mostly of the next
  for (const Polygon& polygon : polygons)
    for (const Ring& ring : polygon.rings)
      for (const Vertex& corner : ring) {
        const Vertex origin = origin_of(corner);
        if (block == nullptr || block->origin != origin) block = &block_at(origin);
        block->bits[Block::row(corner)] |= Block::bit(corner);
      }
  // Three polygons or more meet in a corner. What is reserved and not used costs nothing.
  positions_.reserve(polygons.corner_count() / 3);
  for (Block& each : blocks_) number_block(each);
}

std::uint32_t VertexNumbers::add(const Vertex& vertex) {
  Block& block = block_at(origin_of(vertex));
  if (block.has(vertex)) return number(block, vertex);
  if (block.list == none) list_numbers(block);
  const auto next = static_cast<std::uint32_t>(positions_.size());
  std::vector<std::uint32_t>& numbers = numbers_[block.list];
  numbers.insert(numbers.begin() + block.rank(vertex), next);
  block.bits[Block::row(vertex)] |= Block::bit(vertex);
  block.count_rows();
  positions_.push_back(vertex);
  return next;
}

void VertexNumbers::Block::count_rows() {
  std::uint32_t count = 0;
  for (std::size_t row = 0; row < 8; ++row) {
    before[row] = static_cast<std::uint8_t>(count);
    count += count_of(bits[row]);
  }
}

VertexNumbers::Block& VertexNumbers::block_at(const Vertex& origin) {
  if (2 * blocks_.size() >= slots_.size()) grow();
  std::uint32_t& place = slots_[slot_of(origin)];
  if (place == none) {
    place = static_cast<std::uint32_t>(blocks_.size());
    blocks_.emplace_back().origin = origin;
  }
  return blocks_[place];
}

void VertexNumbers::grow() {
  constexpr std::size_t min_slots = 64;
  slots_.assign(std::max(min_slots, 2 * slots_.size()), none);
  for (std::size_t place = 0; place < blocks_.size(); ++place)
    slots_[slot_of(blocks_[place].origin)] = static_cast<std::uint32_t>(place);
}

void VertexNumbers::number_block(Block& block) {
  block.first = static_cast<std::uint32_t>(positions_.size());
  block.count_rows();
  for (std::int32_t z = 0; z < 8; ++z)
    for (std::uint32_t left = block.bits[z]; left != 0; left &= left - 1) {
      const auto bit = static_cast<std::int32_t>(trailing_zeros(left));
      const std::int32_t y = bit >> 2, x = (bit & 3) << 1;
      positions_.push_back(block.origin + Vertex{x + ((y + z + 1) & 1), y, z});
    }
}

void VertexNumbers::list_numbers(Block& block) {
  std::uint32_t count = 0;
  for (const std::uint32_t row : block.bits) count += count_of(row);
  block.list = static_cast<std::uint32_t>(numbers_.size());
  std::vector<std::uint32_t>& numbers = numbers_.emplace_back();
  for (std::uint32_t i = 0; i < count; ++i) numbers.push_back(block.first + i);
}

}  // namespace discmc::meshing
