// The set of lattice vertices that are corners of polygons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/surface.hpp"

namespace discmc::web {

/// A bit per vertex, in blocks of 8 x 8 x 8 half-steps. Only blocks with corners exist, because
/// surfaces are thin. Memory: four bytes per block of the bounding box, and 64 per block with
/// corners.
class CornerSet {
 public:
  static constexpr std::int32_t max_coordinate = 32767;

  /// Adds the corners of these polygons. Throws std::runtime_error if they lie beyond
  /// max_coordinate, or in a box of too many blocks.
  void fill(const meshing::Polygons& polygons);

  /// Limit: on a side of one of the polygons.
  bool holds(const Vertex& vertex) const {
    const Place place = place_of(vertex);
    const std::uint32_t block = numbers_[place.block];
    return block != none && (blocks_[block][place.word] >> place.bit & 1) != 0;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  static constexpr std::uint64_t max_blocks = std::uint64_t{1} << 26;

  using Block = std::array<std::uint64_t, 8>;
  struct Place {
    std::size_t block, word;
    unsigned bit;
  };
  Place place_of(const Vertex& vertex) const {
    const auto x = static_cast<std::uint32_t>(vertex.x - least_.x);
    const auto y = static_cast<std::uint32_t>(vertex.y - least_.y);
    const auto z = static_cast<std::uint32_t>(vertex.z - least_.z);
    return {(std::size_t{z / 8} * rows_ + y / 8) * columns_ + x / 8, z % 8, y % 8 * 8 + x % 8};
  }
  void lay_out(const meshing::Polygons& polygons);

  Vertex least_{};
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint32_t> numbers_;  // of the blocks
  std::vector<Block> blocks_;
};

}  // namespace discmc::web
