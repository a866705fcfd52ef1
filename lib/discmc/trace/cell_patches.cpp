#include <discmc/trace/cell_patches.hpp>
#include <discmc/trace/loop_facets.hpp>

namespace discmc::trace {

namespace {

void add_link(CellPatch& patch, const Vertex& from, const Vertex& to) {
  const Run link = Run::straight(direction_of(patch.incidence, to - from), 1);
  if (patch.count > 0 && patch.run[patch.count - 1].absorb(link)) return;
  patch.run[patch.count++] = link;
}

// The patch whose facets begin at a point of a loop; for a loop that is one patch, at any point.
// Every one of these points turns out to be a corner of its ring.
CellPatch patch_from(const LoopFacets& facets, int begin) {
  CellPatch patch{facets.behind(begin), facets.loop.point[begin], 0, {}};
  int i = begin;
  const int end = begin + facets.loop.count;
  while (i < end && facets.behind(i) == patch.incidence) {
    add_link(patch, facets.at(i), facets.at(i + 1));
    ++i;
  }
  if (i < end) {
    add_link(patch, facets.at(i), position(centroid));
    add_link(patch, position(centroid), facets.at(begin));
  }
  return patch;
}

}  // namespace

CellPatch cell_patch(Configuration configuration, uint32_t number) {
  const Loops loops = discmc::derive::loops(configuration);
  for (int l = 0; l < loops.count; ++l) {
    const LoopFacets facets = facets_of(loops.loop[l]);
    for (int i = 0; i < facets.loop.count; ++i) {
      if (facets.is_flat() ? i > 0 : !facets.has_spoke(i)) continue;
      if (number-- == 0) return patch_from(facets, i);
    }
  }
  return {};
}

CellCounts cell_counts(Configuration configuration) {
  CellCounts counts{0, 0};
  const Loops loops = discmc::derive::loops(configuration);
  for (int l = 0; l < loops.count; ++l) {
    const LoopFacets facets = facets_of(loops.loop[l]);
    counts.facets += facets.is_fan ? facets.loop.count : 1U;
    counts.classic_triangles += facets.loop.count - 2U;
  }
  return counts;
}

}  // namespace discmc::trace
