#include "vertex_numbers.hpp"

#include <algorithm>

#include <discmc/base/compiler.hpp>

namespace discmc::meshing {

VertexNumbers::Block& VertexNumbers::block_at(const Vertex& origin) {
  const std::uint32_t block = find_block(origin);
  return block != none ? blocks_[block] : new_block(origin);
}

DISCMC_NOINLINE VertexNumbers::Block& VertexNumbers::new_block(const Vertex& origin) {
  if (2 * blocks_.size() + 2 > slots_.size()) set_slots(2 * slots_.size());
  slots_[slot_of(origin)] = static_cast<std::uint32_t>(blocks_.size());
  blocks_.push_back({origin});
  return blocks_.back();
}

void VertexNumbers::set_slots(std::size_t count) {
  slots_.assign(count, none);
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    slots_[slot_of(blocks_[block].origin)] = static_cast<std::uint32_t>(block);
}

// Gives each block in the box around all corners a slot of its own, if there are few of them.
void VertexNumbers::lay_out(const Array<Vertex>& corners) {
  if (corners.empty()) return;
  const auto [low, high] = box_around(corners.begin(), corners.end());
  const auto blocks_from = [](std::int32_t first, std::int32_t last) {
    return static_cast<std::uint64_t>((std::int64_t{last} >> 3) - (std::int64_t{first} >> 3) + 1);
  };
  const std::uint64_t width = blocks_from(low.x, high.x), height = blocks_from(low.y, high.y),
                      depth = blocks_from(low.z, high.z);
  // The first product is below 2^59. The second is made only if the first is small.
  const std::uint64_t max_blocks = corners.size();
  if (width * height > max_blocks || width * height * depth > max_blocks) return;
  steps_ = {1, width, width * height};
  std::size_t slots = 1;
  while (slots < width * height * depth) slots *= 2;
  set_slots(slots);
}

VertexNumbers::VertexNumbers(const Polygons& polygons) {
  lay_out(polygons.corners());
  for (const Polygon& polygon : polygons)
    for (const Vertex& corner : polygon.rings.corners())
      block_at(origin_of(corner)).bits[Block::row(corner)] |= Block::bit(corner);
  // At least three polygons meet in a corner. Unused reserved memory costs nothing.
  positions_.reserve(polygons.corners().size() / 3);
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
