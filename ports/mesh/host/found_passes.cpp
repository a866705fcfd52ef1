#include "found_passes.hpp"
#include <discmc/base/checks.hpp>
#include <discmc/base/compiler.hpp>
#include "corner_code.hpp"

namespace discmc::host {

using detail::trace::Pass;

namespace {

constexpr uint32_t incidences = incidence_bits >> incidence_shift;

// Adds the rays of a half. The first ray exists only if its sector differs from the sector before
// it, the last sector of the other half.
DISCMC_ALWAYS_INLINE RayWord* add_half(RayWord* ray, const HalfRays& half, RayWord first,
                                       RayWord first_before) {
  const uint32_t differ = first >> incidence_shift ^ first_before >> HalfRays::last_shift;
  *ray = first;
  ray += (differ & incidences) != 0 ? 1 : 0;
  // Copies four words; the next ray overwrites the last one.
  copy_bytes(ray, half.ray, sizeof half);
  return ray + (first >> HalfRays::count_shift);
}

}  // namespace

void FoundPasses::find(const Edges& edges, detail::trace::SweepCounts& counts) {
  RayWord* ray = ray_;
  PassVertex* vertex = vertex_;
  uint64_t parts = 0;
  for (const Edge& edge : edges) {
    if (edge.axis >= Edge::special) {
      const AddedCounts added = add_special(edge, ray, vertex);
      ray += added.rays;
      vertex += added.rays != 0 ? 1 : 0;
      parts += added.parts;
      continue;
    }
    constexpr uint32_t half_neighbourhoods = HalfRays::neighbourhoods - 1;
    const uint32_t lines = edge.lines;
    const RayTable::Kind kind_0 = ray_table.kind[0][lines & half_neighbourhoods];
    const RayTable::Kind kind_1 =
        ray_table.kind[1][lines >> HalfRays::lines_bits & half_neighbourhoods];
    parts += ray_table.parts[kind_0.parts];
    parts += ray_table.parts[kind_1.parts];
    const HalfRays& half_0 = ray_table.rays[edge.axis][0][kind_0.rays];
    const HalfRays& half_1 = ray_table.rays[edge.axis][1][kind_1.rays];
    const RayWord first_0 = half_0.first, first_1 = half_1.first;
    RayWord* const begin = ray;
    ray = add_half(ray, half_0, first_0, first_1);
    ray = add_half(ray, half_1, first_1, first_0);
    const uint32_t has_rays = ray != begin ? 1 : 0;
    *ray = *begin | repeated;
    ray += has_rays;
    // If the voxel is on, chains arrive along the next ray; otherwise they leave along it.
    *vertex = {edge.voxel, out_bits >> (lines >> (HalfRays::lines_bits - 3) & 8)};
    vertex += has_rays;
  }
  rays_ = static_cast<uint32_t>(ray - ray_);
  DISCMC_LIMIT(vertex <= vertex_ + Edges::max_edges && rays_ <= max_passes + Edges::max_edges);
  constexpr uint64_t field_mask = (uint64_t{1} << PartSum::bits) - 1;
  counts.add(static_cast<uint32_t>(parts & field_mask),
             static_cast<uint32_t>(parts >> PartSum::bits & field_mask),
             static_cast<uint32_t>(parts >> 2 * PartSum::bits));
}

// Finds the passes at an edge around which cells are absent, or the ends at the seam of a slab.
DISCMC_NOINLINE FoundPasses::AddedCounts FoundPasses::add_special(const Edge& edge, RayWord* ray,
                                                                  PassVertex* vertex) const {
  // Lines 0 to 4 are in the lowest bits. Behind the voxel, line 4 is repeated, before lines 5 to 7.
  constexpr uint32_t first_lines = (1U << HalfRays::lines_bits) - 1;
  const uint32_t lines = (edge.lines & first_lines) |
                         (edge.lines >> (HalfRays::lines_bits + 3) & 63) << HalfRays::lines_bits;
  const bool is_on = (edge.lines >> HalfRays::lines_bits & 1) != 0;
  detail::trace::PassList list;
  detail::trace::derive_passes(
      detail::trace::EdgeLines{static_cast<int>(edge.axis & 3), is_on, lines},
      edge.axis >> Edge::special_shift & 15, list);
  const bool is_at_seam = (edge.axis & Edge::at_seam) != 0;
  RayWord* const first = ray;
  for (uint32_t i = 0; i < list.count; ++i) {
    const Pass& pass = list.pass[i];
    const QueueCode in = queue_traits.code[pass.in_queue], out = queue_traits.code[pass.out_queue];
    if (!is_at_seam) *ray++ = pass_word(in, out, pass.incidence);
    // At a seam, a chain that arrives across it ends here; a chain that leaves across it begins
    // here.
    if (is_at_seam && pass.in_queue >= detail::trace::first_rising_queue)
      *ray++ = pass_word(in, seam_tails, pass.incidence);
    if (is_at_seam && pass.out_queue >= detail::trace::first_rising_queue)
      *ray++ = pass_word(seam_begins, out, pass.incidence);
  }
  const bool has_passes = ray != first;
  *ray = repeated;
  ray += has_passes ? 1 : 0;
  *vertex = {edge.voxel, 0};
  return {static_cast<uint32_t>(ray - first), is_at_seam ? 0 : PartSum::from_part(list.parts)};
}

}  // namespace discmc::host
