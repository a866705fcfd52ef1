#include "numbered_corners.hpp"

#include <algorithm>
#include <memory>

#include "ordered_pipeline.hpp"

namespace discmc::host {
namespace {

constexpr std::size_t polygons_a_block = 1 << 14;

std::size_t block_count(const Surface& surface) {
  return (surface.polygons.size() + polygons_a_block - 1) / polygons_a_block;
}

void number_block(const Surface& surface, std::size_t block, VertexNumbers& vertices,
                  std::vector<std::uint32_t>& numbers) {
  const PolygonSpan span = block_of(surface, block);
  for (std::size_t i = span.first; i < span.end; ++i)
    for (const Ring& ring : surface.polygons[i].rings)
      for (const Vertex& corner : ring) numbers.push_back(vertices.add(corner));
}

}  // namespace

PolygonSpan block_of(const Surface& surface, std::size_t block) {
  const std::size_t first = block * polygons_a_block;
  return {first, std::min(first + polygons_a_block, surface.polygons.size())};
}

// Where there are several jobs, blocks have numbers of their own first.
NumberedCorners number_corners(const Surface& surface, unsigned jobs) {
  NumberedCorners all;
  all.of_block.resize(block_count(surface));
  if (jobs == 1) {
    for (std::size_t block = 0; block < all.of_block.size(); ++block)
      number_block(surface, block, all.vertices, all.of_block[block]);
    return all;
  }
  struct Block {
    std::unique_ptr<VertexNumbers> vertices;
  };
  run_in_order<Block>(
      jobs, all.of_block.size(),
      [](std::size_t, Block& own) { own.vertices = std::make_unique<VertexNumbers>(); },
      [&](std::size_t block, Block& own) {
        number_block(surface, block, *own.vertices, all.of_block[block]);
      },
      [&](std::size_t block, Block& own) {
        std::vector<std::uint32_t> number_in_all;
        for (const Vertex& vertex : own.vertices->positions())
          number_in_all.push_back(all.vertices.add(vertex));
        for (std::uint32_t& number : all.of_block[block]) number = number_in_all[number];
      });
  return all;
}

}  // namespace discmc::host
