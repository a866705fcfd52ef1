// Fuzz target. In any neighbourhood of cells the lookup tables draw a closed surface, and
// neighbours agree about every link between them. Eight bytes of the input are the bits of 4 x 4 x
// 4 voxels, 27 cells; every further eight bytes are another block.
//
//   fuzz_table -max_len=64 corpus/table      with libFuzzer
//   fuzz_table corpus/table                  with replay_main.cpp
#include <map>
#include <vector>

#include "oracle/facet_neighbours.hpp"
#include "oracle/surface.hpp"
#include "require.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr int32_t side = 4;  // voxels

/// A directed link at its position in space.
struct UnitLink {
  Vertex from, to;
};

bool operator<(const UnitLink& a, const UnitLink& b) {
  return a.from == b.from ? before(a.to, b.to) : before(a.from, b.from);
}

// Counts how often a link occurs minus its opposite, without zeros.
class LinkSum {
 public:
  void add(const UnitLink& link) {
    const bool is_forward = before(link.from, link.to);
    const auto entry = sum_.try_emplace(is_forward ? link : UnitLink{link.to, link.from}, 0).first;
    entry->second += is_forward ? 1 : -1;
    if (entry->second == 0) sum_.erase(entry);
  }
  const std::map<UnitLink, int>& sum() const { return sum_; }

 private:
  std::map<UnitLink, int> sum_;
};

std::vector<UnitLink> links_of(const Vertex& cell, const FacetRing& ring) {
  std::vector<UnitLink> result;
  const Vertex origin = cell + cell;
  for (int p = 0; p < ring.count; ++p)
    result.push_back(
        {origin + position(ring.point[p]), origin + position(ring.point[(p + 1) % ring.count])});
  return result;
}

template <class Visit>
void for_each_facet(Configuration configuration, Visit visit) {
  for (int i = facet_table.first[configuration]; i < facet_table.first[configuration + 1]; ++i)
    visit(facet_table.facet[i]);
}

// Facets of neighbouring cells have unpaired links only on the outside of the block.
void check_cancelling(const BitVolume& block) {
  LinkSum sum;
  for_each_cell(block, false, [&](const Vertex& cell, Configuration configuration) {
    for_each_facet(configuration, [&](Facet facet) {
      for (const UnitLink& link : links_of(cell, facet_rings.ring[facet])) sum.add(link);
    });
  });
  constexpr int32_t last = 2 * side - 2;
  const auto outside = [](int32_t a, int32_t b) { return a == b && (a == 0 || a == last); };
  for (const auto& [link, times] : sum.sum()) {
    const auto& [a, b] = link;
    require(times == 1 || times == -1, "a link on the outside belongs to two facets");
    require(outside(a.x, b.x) || outside(a.y, b.y) || outside(a.z, b.z),
            "facets of neighbouring cells do not cancel");
  }
}

// across_edge() leads back, and to a facet of the same plane that shares the edge.
void check_adjacency(const Vertex& cell, Facet facet) {
  const FacetRing& ring = facet_rings.ring[facet];
  require(ring.count == 3 || ring.count == 4, "a facet without a ring is in the table");
  const std::vector<UnitLink> own = links_of(cell, ring);
  for (int edge = 0; edge < ring.count; ++edge) {
    const Neighbour neighbour = across_edge(facet, edge);
    require(incidence_of(neighbour.facet) == incidence_of(facet), "a neighbour on another plane");
    const UnitLink& shared = own[static_cast<size_t>(edge)];
    const FacetRing& other = facet_rings.ring[neighbour.facet];
    bool leads_back = false;
    for (int back = 0; back < other.count; ++back) {
      const UnitLink link = links_of(cell + neighbour.cell, other)[static_cast<size_t>(back)];
      if (link.from != shared.to || link.to != shared.from) continue;
      const Neighbour home = across_edge(neighbour.facet, back);
      leads_back = home.facet == facet && home.cell == -neighbour.cell;
    }
    require(leads_back, "a neighbour's shared edge does not lead back");
  }
}

struct PlacedFacet {
  Vertex cell;
  Facet facet;
};

using FacetsByLink = std::map<UnitLink, std::vector<PlacedFacet>>;

FacetsByLink facets_by_link(const BitVolume& block) {
  FacetsByLink facets;
  for_each_cell(block, false, [&](const Vertex& cell, Configuration configuration) {
    for_each_facet(configuration, [&](Facet facet) {
      for (const UnitLink& link : links_of(cell, facet_rings.ring[facet]))
        facets[link].push_back({cell, facet});
    });
  });
  return facets;
}

// The plane of a facet continues at most in the facet that across_edge() returns.
void check_continuation(const FacetsByLink& facets, const Vertex& cell, Facet facet) {
  const std::vector<UnitLink> own = links_of(cell, facet_rings.ring[facet]);
  for (size_t edge = 0; edge < own.size(); ++edge) {
    const auto across = facets.find({own[edge].to, own[edge].from});
    if (across == facets.end()) continue;
    const Neighbour named = across_edge(facet, static_cast<int>(edge));
    for (const PlacedFacet& other : across->second)
      if (incidence_of(other.facet) == incidence_of(facet))
        require(other.facet == named.facet && other.cell == cell + named.cell,
                "a facet of the plane that across_edge() does not name");
  }
}

// Facets and cells enclose the same volume.
void check_volume(const BitVolume& block) {
  int64_t enclosed = 0;
  for_each_cell(block, true, [&](const Vertex&, Configuration configuration) {
    enclosed += cell_facts.enclosed[configuration];
  });
  const Surface surface = surface_of_cells(block, true);
  require(surface.six_volumes == enclosed, "facets and cells enclose different volumes");
  require(surface.open_links == 0, "the facets of a closed surface leave links over");
}

void check(const BitVolume& block) {
  check_cancelling(block);
  check_volume(block);
  const FacetsByLink facets = facets_by_link(block);
  for_each_cell(block, false, [&](const Vertex& cell, Configuration configuration) {
    for_each_facet(configuration, [&](Facet facet) {
      check_adjacency(cell, facet);
      check_continuation(facets, cell, facet);
    });
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  for (size_t at = 0; at < size && at < 64; at += 8) {
    uint64_t bits = 0;
    for (size_t i = at; i < at + 8 && i < size; ++i) bits |= uint64_t{data[i]} << 8 * (i - at);
    check(from_bits({side, side, side}, bits));
  }
  return 0;
}
