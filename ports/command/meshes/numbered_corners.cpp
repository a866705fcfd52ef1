#include "numbered_corners.hpp"

#include <algorithm>
#include <memory>

#include "ordered_pipeline.hpp"

namespace discmc::host {
namespace {

constexpr std::size_t polygons_a_block = 1 << 14;

}  // namespace

std::size_t block_count(const Polygons& polygons) {
  return (polygons.size() + polygons_a_block - 1) / polygons_a_block;
}

PolygonSpan block_of(const Polygons& polygons, std::size_t block) {
  const std::size_t first = block * polygons_a_block;
  return {first, std::min(first + polygons_a_block, polygons.size())};
}

// Where there are several jobs, blocks have numbers of their own first.
NumberedCorners number_corners(const Polygons& polygons, unsigned jobs) {
  NumberedCorners all;
  const std::vector<Vertex>& corners = polygons.corners();
  all.numbers.resize(corners.size());
  if (jobs == 1) {
    for (std::size_t i = 0; i < corners.size(); ++i) all.numbers[i] = all.vertices.add(corners[i]);
    return all;
  }
  struct Block {
    std::unique_ptr<VertexNumbers> vertices;
  };
  const auto each_number = [&](std::size_t block, auto call) {
    const PolygonSpan span = block_of(polygons, block);
    for (std::size_t i = polygons.first_corner(span.first); i < polygons.first_corner(span.end);
         ++i)
      call(i, all.numbers[i]);
  };
  run_in_order<Block>(
      jobs, block_count(polygons),
      [](std::size_t, Block& own) { own.vertices = std::make_unique<VertexNumbers>(); },
      [&](std::size_t block, Block& own) {
        each_number(block, [&](std::size_t i, std::uint32_t& number) {
          number = own.vertices->add(corners[i]);
        });
      },
      [&](std::size_t block, Block& own) {
        std::vector<std::uint32_t> number_in_all;
        for (const Vertex& vertex : own.vertices->positions())
          number_in_all.push_back(all.vertices.add(vertex));
        each_number(
            block, [&](std::size_t, std::uint32_t& number) { number = number_in_all[number]; });
      });
  return all;
}

}  // namespace discmc::host
