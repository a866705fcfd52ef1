// Statements about adjacent facets: across the edge of a facet, and around a vertex; by exhaustion.
#include <discmc/geometry/facet_table.hpp>

#include "oracle/facet_neighbours.hpp"
#include "test.hpp"

using namespace discmc;
using reference::across_edge;
using reference::Neighbour;

namespace {

using PointLink = std::pair<CellPoint, CellPoint>;

template <typename Check>
void for_each_link(Facet facet, Check check) {
  const FacetRing& ring = facet_rings.ring[facet];
  for (int i = 0; i < ring.count; ++i) check(i, ring.point[i], ring.point[(i + 1) % ring.count]);
}

// Every edge of every facet.
template <typename Check>
void for_each_facet_edge(Check check) {
  for (int code = 0; code < facet_codes; ++code)
    for_each_link(static_cast<Facet>(code), [&](int edge, CellPoint from, CellPoint to) {
      INFO("code ", code, ", edge ", edge);
      check(static_cast<Facet>(code), edge, position(from), position(to));
    });
}

// Returns the edge of `facet`, in a cell at `cell`, from one vertex to another, or -1.
int edge_between(Facet facet, const Vertex& cell, const Vertex& from, const Vertex& to) {
  int found = -1;
  for_each_link(facet, [&](int edge, CellPoint a, CellPoint b) {
    if (cell + cell + position(a) == from && cell + cell + position(b) == to) found = edge;
  });
  return found;
}

// The four cells around an edge of the lattice. The edge runs along `axis`; its midpoint is in the
// middle. Quadrant bits 0 and 1 are the side of a cell on the other two axes.
struct AroundEdge {
  static constexpr int quadrants = 4;
  static constexpr int voxels = 18;  // 3 x 3 across, 2 along
  static constexpr int neighbours = 5 * 5 * 5;
  int axis;

  int across(int i) const { return (axis + 1 + i) % 3; }

  // The voxel at u, v (0 to 2) across and w (0 or 1) along.
  static int voxel(int u, int v, int w) { return u + 3 * v + 9 * w; }
  static bool is_crossed(uint32_t voxel_bits) {
    return (voxel_bits >> voxel(1, 1, 0) & 1) != (voxel_bits >> voxel(1, 1, 1) & 1);
  }

  Configuration configuration(uint32_t voxel_bits, int quadrant) const {
    unsigned bits = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const int u = (quadrant & 1) + (corner >> across(0) & 1);
      const int v = (quadrant >> 1) + (corner >> across(1) & 1);
      bits |= (voxel_bits >> voxel(u, v, corner >> axis & 1) & 1) << corner;
    }
    return static_cast<Configuration>(bits);
  }

  // Returns the midpoint as a point of a quadrant's cell.
  Vertex midpoint(int quadrant) const {
    std::array<int32_t, 3> p{};
    p.at(static_cast<size_t>(axis)) = 1;
    p.at(static_cast<size_t>(across(0))) = (quadrant & 1) != 0 ? 0 : 2;
    p.at(static_cast<size_t>(across(1))) = (quadrant >> 1) != 0 ? 0 : 2;
    return {p[0], p[1], p[2]};
  }
};

// A facet at the midpoint as a step around the midpoint: from the next neighbour in the facet's
// ring to the previous one.
struct Step {
  size_t from, to;
};

// By quadrant and configuration: the steps of the facets.
using Steps = std::array<std::array<std::vector<Step>, configurations>, AroundEdge::quadrants>;

size_t neighbour_number(const Vertex& offset) {
  return static_cast<size_t>(offset.x + 2 + 5 * (offset.y + 2) + 25 * (offset.z + 2));
}

Steps tabulate_steps(const AroundEdge& around) {
  Steps steps;
  for (int quadrant = 0; quadrant < AroundEdge::quadrants; ++quadrant) {
    const Vertex middle = around.midpoint(quadrant);
    for (int c = 0; c < configurations; ++c)
      for (int i = facet_table.first[c]; i < facet_table.first[c + 1]; ++i) {
        const FacetRing& ring = facet_rings.ring[facet_table.facet[i]];
        for (int p = 0; p < ring.count; ++p) {
          if (position(ring.point[p]) != middle) continue;
          const Vertex after = position(ring.point[(p + 1) % ring.count]) - middle;
          const Vertex before = position(ring.point[(p + ring.count - 1) % ring.count]) - middle;
          steps[static_cast<size_t>(quadrant)][static_cast<size_t>(c)].push_back(
              {neighbour_number(after), neighbour_number(before)});
        }
      }
  }
  return steps;
}

// Whether the facets at the midpoint form one closed cycle around it, a disc.
bool is_disc(const AroundEdge& around, const Steps& steps, uint32_t voxel_bits) {
  constexpr size_t none = AroundEdge::neighbours;
  std::array<size_t, AroundEdge::neighbours> next;
  next.fill(none);
  size_t count = 0;
  size_t start = none;
  for (int quadrant = 0; quadrant < AroundEdge::quadrants; ++quadrant) {
    const Configuration c = around.configuration(voxel_bits, quadrant);
    for (const Step& step : steps[static_cast<size_t>(quadrant)][c]) {
      if (next[step.from] != none) return false;
      next[step.from] = step.to;
      start = step.from;
      ++count;
    }
  }
  if (count < 3) return false;
  size_t here = start;
  for (size_t i = 0; i < count; ++i) {
    here = next[here];
    if (here == none || (here == start) != (i + 1 == count)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("across_edge() returns the only facet at an edge among all shapes in nearby cells") {
  for_each_facet_edge([](Facet facet, int edge, const Vertex& from, const Vertex& to) {
    const Neighbour across = across_edge(facet, edge);
    int found = 0;
    for (int c = 0; c < 27; ++c)
      for (Shape shape = 0; shape < 8; ++shape) {
        const Vertex cell{c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1};
        const Facet other = facet_of(incidence_of(facet), shape);
        if (edge_between(other, cell, to, from) < 0) continue;
        ++found;
        CHECK(cell == across.cell);
        CHECK(other == across.facet);
      }
    CHECK(found == 1);
  });
}

TEST_CASE("across_edge() stays in the cell at an inner edge, and enters the next cell at a face") {
  constexpr Vertex beyond[] = {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0},
                               {0, 1, 0},  {0, 0, 1},  {0, 0, 0}};
  for_each_facet_edge([&](Facet facet, int edge, const Vertex& from, const Vertex& to) {
    const int face = face_of(point_at(from), point_at(to));
    CHECK(across_edge(facet, edge).cell == beyond[face]);
  });
}

TEST_CASE("the surface around every edge midpoint is a disc, in all 2^18 neighbourhoods") {
  // The four cells around the edge have 18 voxels, and no other cell has facets at the midpoint.
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    const AroundEdge around{axis};
    const Steps steps = tabulate_steps(around);
    uint32_t crossed = 0;
    uint32_t discs = 0;
    uint32_t touched = 0;
    for (uint32_t voxels = 0; voxels < 1U << AroundEdge::voxels; ++voxels) {
      if (AroundEdge::is_crossed(voxels)) {
        ++crossed;
        discs += is_disc(around, steps, voxels);
      } else {
        for (int quadrant = 0; quadrant < AroundEdge::quadrants; ++quadrant)
          touched +=
              !steps[static_cast<size_t>(quadrant)][around.configuration(voxels, quadrant)].empty();
      }
    }
    CHECK(crossed == 1U << (AroundEdge::voxels - 1));
    CHECK(discs == crossed);
    CHECK_MESSAGE(touched == 0, "an edge that is not crossed has no vertex");
  }
}

TEST_CASE("the surface around every centroid is a disc") {
  for (int c = 0; c < configurations; ++c) {
    CAPTURE(c);
    std::vector<PointLink> fan;
    for (int i = facet_table.first[c]; i < facet_table.first[c + 1]; ++i) {
      const FacetRing& ring = facet_rings.ring[facet_table.facet[i]];
      if (ring.point[0] == centroid) fan.push_back({ring.point[1], ring.point[2]});
    }
    if (fan.empty()) continue;
    CellPoint here = fan[0].first;
    size_t steps = 0;
    do {
      const auto step = std::find_if(fan.begin(), fan.end(),
                                     [&](const PointLink& link) { return link.first == here; });
      REQUIRE(step != fan.end());
      here = step->second;
    } while (++steps < fan.size() && here != fan[0].first);
    CHECK(here == fan[0].first);
    CHECK(steps == fan.size());
  }
}
