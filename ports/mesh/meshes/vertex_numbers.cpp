#include "vertex_numbers.hpp"

#include <algorithm>

#include "jobs/parallel.hpp"

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
  box_ = box_around(corners.begin(), corners.end());
  const auto& [low, high] = box_;
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

void VertexNumbers::mark_corners(const Polygons& polygons, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) {
    const Ring corners = polygons[i].rings.corners();
    for (const Vertex& corner : corners)
      block_at(origin_of(corner)).bits[Block::row(corner)] |= Block::bit(corner);
  }
}

void VertexNumbers::merge_marks(const VertexNumbers& part) {
  for (const Block& each : part.blocks_) {
    Block& block = block_at(each.origin);
    for (std::size_t row = 0; row < std::size(block.bits); ++row) block.bits[row] |= each.bits[row];
  }
}

VertexNumbers::VertexNumbers(const Polygons& polygons, unsigned jobs) {
  lay_out(polygons.corners());
  // Parts of polygons that follow each other, marked in parallel and merged in order. Each part has
  // slots of its own, so more parts would need more memory than they save time.
  constexpr std::size_t max_parts = 4, polygons_per_part = 1 << 12;
  const std::size_t parts =
      std::min<std::size_t>({jobs, max_parts, 1 + polygons.size() / polygons_per_part});
  std::vector<VertexNumbers> others(parts - 1, *this);
  for_each_in_parallel(jobs, parts, [&](std::size_t part) {
    (part == 0 ? *this : others[part - 1])
        .mark_corners(polygons, polygons.size() * part / parts,
                      polygons.size() * (part + 1) / parts);
  });
  for (const VertexNumbers& part : others) merge_marks(part);
  for (Block& each : blocks_) {
    each.first = size_;
    size_ += each.count_rows();
  }
}

std::uint32_t VertexNumbers::add(const Vertex& vertex) {
  Block& block = block_at(origin_of(vertex));
  if (block.has(vertex)) return number(block, block.rank(vertex));
  if (block.list == none) list_numbers(block);
  std::vector<std::uint32_t>& numbers = numbers_[block.list];
  numbers.insert(numbers.begin() + block.rank(vertex), size_);
  block.bits[Block::row(vertex)] |= Block::bit(vertex);
  block.count_rows();
  return size_++;
}

std::uint32_t VertexNumbers::Block::count_rows() {
  std::uint32_t count = 0;
  for (std::size_t row = 0; row < 8; ++row) {
    before[row] = static_cast<std::uint8_t>(count);
    count += count_of(bits[row]);
  }
  return count;
}

std::vector<Vertex> VertexNumbers::positions(unsigned jobs) const {
  std::vector<Vertex> positions(size_);
  for_each_in_parallel(jobs, part_count(), [&](std::size_t part) {
    for_each(part, [&positions](std::uint32_t number, const Vertex& vertex) {
      positions[number] = vertex;
    });
  });
  return positions;
}

void VertexNumbers::list_numbers(Block& block) {
  std::uint32_t count = 0;
  for (const std::uint32_t row : block.bits) count += count_of(row);
  block.list = static_cast<std::uint32_t>(numbers_.size());
  std::vector<std::uint32_t>& numbers = numbers_.emplace_back();
  for (std::uint32_t i = 0; i < count; ++i) numbers.push_back(block.first + i);
}

}  // namespace discmc::meshing
