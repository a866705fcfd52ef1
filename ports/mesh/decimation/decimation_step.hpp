// One step of a decimation: all collapses within a distance.
#ifndef DISCMC_MESH_DECIMATION_DECIMATION_STEP_HPP
#define DISCMC_MESH_DECIMATION_DECIMATION_STEP_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "collapsing_mesh.hpp"
#include "distance_bound.hpp"
#include "edge_placing.hpp"
#include "meshes/box_tree.hpp"

namespace discmc::meshing {

/// The surface between two steps.
struct DecimatedSurface {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  LeftPoints left;
};

/// Collapses edges of a surface in the order of their costs, until no more can be collapsed.
class DecimationStep {
 public:
  /// distance: from the original surface, in both directions. triangles: the number at which the
  /// step ends early. check: called regularly.
  DecimationStep(const DecimatedSurface& from, const OriginalSurface& original, double distance,
                 std::uint64_t triangles, const std::function<void()>& check);

  /// Collapses edges first within blocks of near triangles, whose costs fit into the cache, then
  /// across blocks.
  void collapse_in_blocks();
  /// Collapses all edges in one order.
  void collapse_all();

  DecimatedSurface result();

 private:
  struct Entry {
    double cost;
    std::uint32_t low, high;                        // vertices of the edge
    std::uint32_t changes_of_low, changes_of_high;  // when the cost was computed

    bool operator<(const Entry& other) const {  // puts the lowest cost on top of a heap
      if (cost != other.cost) return cost > other.cost;
      return low != other.low ? low > other.low : high > other.high;
    }
  };
  static constexpr std::uint32_t everywhere = ~0U;  // a block number

  void find_blocks();
  bool is_in_block(std::uint32_t a, std::uint32_t b) const {
    return block_ == everywhere || (block_of_[a] == block_ && block_of_[b] == block_);
  }
  // Whether the edge was tried with its block and refused.
  bool is_settled(std::uint32_t a, std::uint32_t b) const {
    return block_ == everywhere && !block_of_.empty() && block_of_[a] != everywhere &&
           block_of_[a] == block_of_[b];
  }
  void add_edges(std::uint32_t vertex);
  void add(std::uint32_t a, std::uint32_t b);
  void refuse(std::uint32_t a, std::uint32_t b) { is_refused_[a] = is_refused_[b] = true; }
  bool is_current(const Entry& entry) const;
  void collapse_queued();
  bool is_allowed();
  void carry_out();
  void drop_outdated();

  const OriginalSurface& original_;
  double distance_;
  std::uint64_t wanted_;
  const std::function<void()>& check_;
  CollapsingMesh mesh_;
  LeftPoints left_;
  EdgePlacing placing_;
  BoxTree tree_;
  std::vector<std::uint32_t> block_of_;  // per vertex; everywhere: in several blocks
  std::uint32_t block_ = everywhere;     // current block
  std::vector<Entry> heap_;
  std::vector<std::uint32_t> changes_;    // number of moves per vertex
  std::vector<std::uint8_t> is_refused_;  // per vertex: whether an edge of it was refused
  Collapse collapse_;
  std::vector<std::uint32_t> ring_;  // neighbours of the vertex that moved
};

}  // namespace discmc::meshing

#endif
