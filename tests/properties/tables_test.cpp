// Statements that any wrong byte of a derived table breaks (proofs/table_mutation tries every
// one), and patches on either side of a face; by exhaustion.
#include <doctest/doctest.h>

#include <map>
#include <utility>

#include "oracle/table_statements.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

/// Where a link runs, by its place within the face.
using PlacedLinks = std::map<int, std::pair<Point, Point>>;

// The links of a cell's patches on a face, by place within the face, moved by `shift`.
PlacedLinks links_on(int face, int configuration, const Vertex& shift) {
  PlacedLinks placed;
  for (uint32_t i = patch_table.first(configuration); i < patch_table.first(configuration + 1);
       ++i) {
    const Patch patch = patch_table.at(i);
    Point from = patch.start;
    for (int l = 0; l < patch.count; ++l) {
      const Point to = point_after(from, link_of(patch.incidence, patch.direction(l)));
      if (patch.place(l) / 2 == face)
        placed[patch.place(l) % 2] = {point_at(position(from) + shift),
                                      point_at(position(to) + shift)};
      from = to;
    }
  }
  return placed;
}

PlacedLinks turned_round(PlacedLinks placed) {
  for (auto& [place, link] : placed) std::swap(link.first, link.second);
  return placed;
}

bool share_face(int axis, int cell, int next) {
  for (int corner = 0; corner < 8; ++corner)
    if ((corner >> axis & 1) == 0 && (cell >> (corner | 1 << axis) & 1) != (next >> corner & 1))
      return false;
  return true;
}

}  // namespace

TEST_CASE("links are numbered in order, and the directions of a plane go round") {
  CHECK(broken(links) == nullptr);
}

TEST_CASE("the facets of every configuration fill its loops, and are counted right") {
  CHECK(broken(facet_tables()) == nullptr);
}

TEST_CASE("the patches of every configuration are its facets, plane by plane") {
  CHECK(broken(patch_table) == nullptr);
}

TEST_CASE("the patches of two cells that share a face have the same links in the same places") {
  constexpr Vertex back[] = {{-2, 0, 0}, {0, -2, 0}, {0, 0, -2}};
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    int pairs = 0;
    for (int cell = 0; cell < configurations; ++cell)
      for (int next = 0; next < configurations; ++next) {
        if (!share_face(axis, cell, next)) continue;
        ++pairs;
        if (links_on(axis + 3, cell, back[axis]) != turned_round(links_on(axis, next, {0, 0, 0})))
          FAIL_CHECK("cells ", cell, " and ", next);
      }
    CHECK(pairs == 4096);
  }
}
