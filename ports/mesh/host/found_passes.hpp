// Finds the passes at a batch of edges. The words of two neighbouring rays define a pass.
#ifndef DISCMC_MESH_HOST_FOUND_PASSES_HPP
#define DISCMC_MESH_HOST_FOUND_PASSES_HPP

#include <discmc/trace/passes.hpp>
#include "edges.hpp"
#include "ray_table.hpp"

namespace discmc::host {

class FoundPasses {
 public:
  static constexpr uint32_t max_passes = Edges::max_edges * detail::trace::PassList::max_passes;

  /// Finds the passes of a batch of edges, and adds to the counts of cells.
  void find(const Edges& edges, detail::trace::SweepCounts& counts);

  /// Calls visit(voxel, pass) for each pass. voxel: at the lower end of its edge, as
  /// CornerCode::position().
  template <class Visit>
  DISCMC_ALWAYS_INLINE void for_each(Visit visit) const {
    const PassVertex* vertex = vertex_;
    for (const RayWord *ray = ray_, *const end = ray_ + rays_; ray != end;) {
      const RayWord next = ray[1];
      visit(vertex->voxel, ray[0] ^ ((ray[0] ^ next) & vertex->next_bits));
      ray += 1 + (next >> 31);
      vertex += next >> 31;
    }
  }

 private:
  // Set in the word behind the last ray of a vertex, which repeats the first ray.
  static constexpr uint32_t repeated = 1U << 31;

  // The voxel of a vertex, and the bits that a pass copies from its next ray: in_bits, out_bits, or
  // none for special vertices.
  struct PassVertex {
    uint64_t voxel;
    uint32_t next_bits;
  };

  struct AddedCounts {
    uint32_t rays;
    uint64_t parts;
  };

  AddedCounts add_special(const Edge& edge, RayWord* ray, PassVertex* vertex) const;

  uint32_t rays_ = 0;  // including repeated ones
  PassVertex vertex_[Edges::max_edges + 1] = {};
  // Four words are copied behind a first ray, so the array has room beyond the last ray.
  RayWord ray_[max_passes + Edges::max_edges + 5] = {};
  static_assert(2 * sizeof(HalfRays) == detail::trace::PassList::max_passes * sizeof(RayWord),
                "a vertex has as many rays as two halves");
  static_assert(Edges::max_at_seam * (2 * detail::trace::PassList::max_passes + 1) <=
                    max_passes + Edges::max_edges,
                "both ends of each pass at a seam have room");
};

}  // namespace discmc::host

#endif
