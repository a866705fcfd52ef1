// Numbers positions of the lattice.
#ifndef DISCMC_MESH_MESHES_VERTEX_NUMBERS_HPP
#define DISCMC_MESH_MESHES_VERTEX_NUMBERS_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/base/compiler.hpp>
#include <discmc/lattice.hpp>

#include "surface/polygons.hpp"

namespace discmc::meshing {

/// Numbers vertices from zero on. The lattice is divided into blocks of 8 x 8 x 8 points; each
/// block has a bit per vertex. A vertex's number is the block's first number plus the count of bits
/// before its own. Blocks without a vertex use no memory, and positions follow from the bits.
/// Limit: vertices of the lattice, which have an odd coordinate sum.
class VertexNumbers {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  VertexNumbers() = default;
  /// Numbers all corners of polygons, block by block, in the order in which polygons reach the
  /// blocks. jobs: threads that share the work. Limit: at least one job.
  explicit VertexNumbers(const Polygons& polygons, unsigned jobs = 1);

  /// Returns the number of a vertex. A new vertex gets the next number.
  std::uint32_t add(const Vertex& vertex);

  /// Returns the number of a vertex, or none.
  std::uint32_t find(const Vertex& vertex) const {
    const std::uint32_t block = find_block(origin_of(vertex));
    return block != none && blocks_[block].has(vertex)
               ? number(blocks_[block], blocks_[block].rank(vertex))
               : none;
  }

  bool has(const Vertex& vertex) const {
    const std::uint32_t block = find_block(origin_of(vertex));
    return block != none && blocks_[block].has(vertex);
  }

  /// The box around the corners of the polygons. Limit: at least one corner.
  const VertexBox& box() const { return box_; }
  /// The number of vertices.
  std::uint32_t size() const { return size_; }
  /// Returns the positions of all vertices, by number.
  std::vector<Vertex> positions(unsigned jobs = 1) const;
  /// Vertices are visited in parts of some thousands.
  std::size_t part_count() const {
    return (blocks_.size() + blocks_per_part - 1) / blocks_per_part;
  }
  /// Calls call(number, vertex) for each vertex of a part. Numbers ascend, also from part to part,
  /// if none was added.
  template <class Call>
  void for_each(std::size_t part, Call call) const {
    const std::size_t end = std::min((part + 1) * blocks_per_part, blocks_.size());
    for (std::size_t i = part * blocks_per_part; i < end; ++i) for_each_of(blocks_[i], call);
  }

 private:
  static constexpr std::size_t blocks_per_part = 1 << 9;

  struct Block {
    static std::uint32_t row(const Vertex& vertex) {
      return static_cast<std::uint32_t>(vertex.z & 7);
    }
    static std::uint32_t bit(const Vertex& vertex) {
      return std::uint32_t{1} << ((vertex.y & 7) << 2 | (vertex.x & 7) >> 1);
    }

    bool has(const Vertex& vertex) const { return (bits[row(vertex)] & bit(vertex)) != 0; }
    /// Returns the number of vertices of the block before this one.
    std::uint32_t rank(const Vertex& vertex) const {
      return before[row(vertex)] + count_of(bits[row(vertex)] & (bit(vertex) - 1));
    }
    /// Returns the number of vertices.
    std::uint32_t count_rows();

    Vertex origin;
    std::uint32_t first = 0;      ///< number of the block's first vertex
    std::uint32_t list = none;    ///< index in numbers_, if vertices were added later
    std::uint8_t before[8] = {};  ///< number of vertices in earlier rows
    std::uint32_t bits[8] = {};   ///< by z, then y, then x
  };

  static std::uint32_t count_of(std::uint32_t bits) {
    bits -= bits >> 1 & 0x55555555u;
    bits = (bits & 0x33333333u) + (bits >> 2 & 0x33333333u);
    return ((bits + (bits >> 4)) & 0x0F0F0F0Fu) * 0x01010101u >> 24;
  }
  static Vertex origin_of(const Vertex& vertex) {
    return {vertex.x & ~7, vertex.y & ~7, vertex.z & ~7};
  }
  // rank: the number of vertices of the block before the vertex.
  std::uint32_t number(const Block& block, std::uint32_t rank) const {
    return block.list == none ? block.first + rank : numbers_[block.list][rank];
  }

  std::uint32_t find_block(const Vertex& origin) const { return slots_[slot_of(origin)]; }
  // Returns the slot of the block, occupied or free.
  std::size_t slot_of(const Vertex& origin) const {
    const auto part = [](std::int32_t coordinate, std::uint64_t step) {
      return (static_cast<std::uint32_t>(coordinate) >> 3) * step;
    };
    const std::uint64_t hash =
        part(origin.x, steps_[0]) + part(origin.y, steps_[1]) + part(origin.z, steps_[2]);
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    while (slots_[slot] != none && blocks_[slots_[slot]].origin != origin) slot = (slot + 1) & mask;
    return slot;
  }
  template <class Call>
  void for_each_of(const Block& block, Call call) const {
    std::uint32_t rank = 0;
    for (std::int32_t z = 0; z < 8; ++z)
      for (std::uint32_t vertices = block.bits[z]; vertices != 0;
           vertices &= vertices - 1, ++rank) {
        const auto bit = static_cast<std::int32_t>(trailing_zeros(vertices));
        const std::int32_t y = bit >> 2, x = (bit & 3) << 1;
        call(number(block, rank), block.origin + Vertex{x + ((y + z + 1) & 1), y, z});
      }
  }
  Block& block_at(const Vertex& origin);
  Block& new_block(const Vertex& origin);
  void set_slots(std::size_t count);
  void lay_out(const Array<Vertex>& corners);
  void mark_corners(const Polygons& polygons, std::size_t first, std::size_t end);
  void merge_marks(const VertexNumbers& part);
  void list_numbers(Block& block);

  // Indexes of blocks, hashed; at least half are free. The hash is the sum of the coordinates of a
  // block, times steps.
  std::vector<std::uint32_t> slots_{none};
  std::array<std::uint64_t, 3> steps_{0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu,
                                      0x165667B19E3779F9u};
  Array<Block> blocks_;
  std::vector<std::vector<std::uint32_t>> numbers_;
  std::uint32_t size_ = 0;
  VertexBox box_{};
};

}  // namespace discmc::meshing

#endif
