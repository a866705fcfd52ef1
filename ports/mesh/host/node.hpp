// A vertex that a chain passes, and the corners there.
#ifndef DISCMC_MESH_HOST_NODE_HPP
#define DISCMC_MESH_HOST_NODE_HPP

#include <discmc/base/compiler.hpp>
#include "corner_code.hpp"
#include "ray_table.hpp"

namespace discmc::host {

/// A vertex that a chain passes.
struct Node {
  uint64_t voxel;  // CornerCode::position()
  uint32_t next;   // the next node of the chain, no_node, or a waiting_tail
  PassWord pass;

  static constexpr uint32_t no_node = UINT32_MAX;
  /// Added to the seat of a tail, while nodes are copied.
  static constexpr uint32_t waiting_tail = 1U << 31;
  /// The pass of a shortcut, which has no corner. Its voxel is the number of the node up to which
  /// the chain has been followed.
  static constexpr PassWord shortcut = 1U << 31 | pass_word(seam_tails, seam_begins, 0);

  bool turns() const {
    return queue_traits.incoming[in_of(pass)] != queue_traits.outgoing[out_of(pass)];
  }
  bool turns_behind() const { return queue_traits.turns[out_of(pass)] != 0; }
  bool has_corner() const { return turns() || turns_behind(); }
  bool ends_at_seam() const { return out_of(pass) == seam_tails; }

  /// The corner at the vertex, if turns(); the corner at the centroid behind it, if turns_behind().
  uint64_t corner() const {
    return plane() + queue_traits.vertex[in_of(pass)] + queue_traits.outgoing[out_of(pass)];
  }
  uint64_t corner_behind() const { return plane() + queue_traits.centroid[out_of(pass)]; }

  /// Writes zero to two corners, without branches. Returns a pointer behind the last one. Limit:
  /// there is room for two.
  DISCMC_ALWAYS_INLINE uint64_t* append_corners(uint64_t* corners) const {
    corners[0] = corner();
    corners += turns() ? 1 : 0;
    corners[0] = corner_behind();
    return corners + queue_traits.turns[out_of(pass)];
  }

 private:
  uint64_t plane() const {
    static_assert(incidence_shift > CornerCode::incidence_shift);
    return voxel + ((pass & incidence_bits) >> (incidence_shift - CornerCode::incidence_shift));
  }
};

}  // namespace discmc::host

#endif
