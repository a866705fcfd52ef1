#include "merge.hpp"

#include <algorithm>
#include <array>

#include <unordered_set>
#include "facet_neighbours.hpp"

namespace discmc::reference {

namespace {

struct PlacedFacet {
  Vertex cell;
  Facet facet;
};

bool operator==(const PlacedFacet& a, const PlacedFacet& b) {
  return a.cell == b.cell && a.facet == b.facet;
}

struct Hash {
  size_t operator()(const PlacedFacet& key) const {
    const auto bits = [](int32_t coordinate) { return static_cast<uint64_t>(coordinate + 1); };
    const uint64_t cell = bits(key.cell.z) << 40 ^ bits(key.cell.y) << 20 ^ bits(key.cell.x);
    return std::hash<uint64_t>()(cell << 3 ^ shape_of(key.facet));
  }
};

// The facets of one incidence that belong to no region yet, by cell and shape.
using HashTable = std::unordered_set<PlacedFacet, Hash>;
using HashTables = std::array<HashTable, incidence_codes>;

// An edge of a facet, from point `number` of its ring to the next.
struct Edge {
  PlacedFacet facet;
  int number;
};

// An edge by its position in space.
struct UnitLink {
  Vertex from, to;
};

bool operator<(const UnitLink& a, const UnitLink& b) {
  return a.from == b.from ? before(a.to, b.to) : before(a.from, b.from);
}

UnitLink link_of(const Edge& edge) {
  const FacetRing& ring = facet_rings.ring[edge.facet.facet];
  const Vertex origin = edge.facet.cell + edge.facet.cell;
  const int next = (edge.number + 1) % ring.count;
  return {origin + position(ring.point[edge.number]), origin + position(ring.point[next])};
}

PlacedFacet neighbour_across(const Edge& edge) {
  const Neighbour& neighbour = tabulated_neighbour(edge.facet.facet, edge.number);
  return {edge.facet.cell + neighbour.cell, neighbour.facet};
}

void push_edges(std::vector<Edge>& stack, const PlacedFacet& facet) {
  for (int edge = 0; edge < facet_rings.ring[facet.facet].count; ++edge)
    stack.push_back({facet, edge});
}

// Removes a facet from the table and grows it across its edges as far as possible. Returns the
// links at which the growth stopped: the boundary, and both sides of every connecting link.
std::vector<UnitLink> grow(HashTable& waiting) {
  std::vector<UnitLink> stops;
  std::vector<Edge> stack;
  push_edges(stack, *waiting.begin());
  waiting.erase(waiting.begin());
  while (!stack.empty()) {
    const Edge edge = stack.back();
    stack.pop_back();
    const PlacedFacet neighbour = neighbour_across(edge);
    if (waiting.erase(neighbour) == 0) {
      stops.push_back(link_of(edge));
      continue;
    }
    // The shared edge is in no boundary, so neither side is pushed.
    for (int other = 0; other < facet_rings.ring[neighbour.facet].count; ++other)
      if (!(neighbour_across({neighbour, other}) == edge.facet))
        stack.push_back({neighbour, other});
  }
  return stops;
}

// Facets of the region lie on both sides of a connecting link, so it occurs in both directions.
std::vector<UnitLink> without_connecting_links(std::vector<UnitLink> stops) {
  std::sort(stops.begin(), stops.end());
  std::vector<UnitLink> boundary;
  for (const UnitLink& link : stops)
    if (!std::binary_search(stops.begin(), stops.end(), UnitLink{link.to, link.from}))
      boundary.push_back(link);
  return boundary;
}

// Returns the position in the sorted `boundary` of the next link of a simple ring: the first link
// counter-clockwise from the last one. Returns boundary.size() if there is none, which only a wrong
// table causes.
size_t next_link(Incidence incidence, const std::vector<UnitLink>& boundary, const UnitLink& link) {
  const int directions = direction_count(incidence);
  const int way_back = direction_of(incidence, link.from - link.to);
  size_t next = boundary.size();
  int min_turn = directions;
  auto candidate = std::lower_bound(
      boundary.begin(), boundary.end(), link.to,
      [](const UnitLink& other, const Vertex& vertex) { return before(other.from, vertex); });
  for (; candidate != boundary.end() && candidate->from == link.to; ++candidate) {
    const int direction = direction_of(incidence, candidate->to - candidate->from);
    const int turn = (direction - way_back + directions) % directions;
    if (turn >= min_turn) continue;
    min_turn = turn;
    next = static_cast<size_t>(candidate - boundary.begin());
  }
  return next;
}

std::vector<Ring> chain(Incidence incidence, const std::vector<UnitLink>& boundary) {
  std::vector<Ring> rings;
  std::vector<bool> chained(boundary.size());
  for (size_t first = 0; first < boundary.size(); ++first) {
    if (chained[first]) continue;
    Ring& ring = rings.emplace_back();
    for (size_t link = first; link < boundary.size() && !chained[link];
         link = next_link(incidence, boundary, boundary[link])) {
      chained[link] = true;
      ring.push_back(boundary[link].from);
    }
  }
  // Rings are chained in the order of vertices, so holes may precede an outer ring that they touch.
  std::stable_partition(rings.begin(), rings.end(),
                        [&](const Ring& ring) { return signed_area(incidence, ring) > 0; });
  return rings;
}

HashTables load_tables(const BitVolume& volume, bool is_closed, const FacetTable& table) {
  HashTables tables;
  for_each_cell(volume, is_closed, [&](const Vertex& cell, Configuration configuration) {
    for (int i = table.first[configuration]; i < table.first[configuration + 1]; ++i)
      tables[incidence_of(table.facet[i])].insert({cell, table.facet[i]});
  });
  return tables;
}

}  // namespace

std::vector<Region> merge(const BitVolume& volume, bool is_closed, const FacetTable& table) {
  HashTables tables = load_tables(volume, is_closed, table);
  std::vector<Region> regions;
  for (size_t i = 0; i < tables.size(); ++i) {
    const auto incidence = static_cast<Incidence>(i);
    while (!tables[i].empty()) {
      const std::vector<UnitLink> boundary = without_connecting_links(grow(tables[i]));
      regions.push_back({incidence, chain(incidence, boundary)});
    }
  }
  return regions;
}

}  // namespace discmc::reference
