#include "forest.hpp"

#include <algorithm>

#include "oracle/surface.hpp"

namespace discmc::prove {

namespace {

struct FacetLink {
  CellPoint from, to;
};

std::vector<FacetLink> links_of(Facet facet) {
  const FacetRing& ring = facet_rings.ring[facet];
  std::vector<FacetLink> links;
  for (int i = 0; i < ring.count; ++i)
    links.push_back({ring.point[i], ring.point[(i + 1) % ring.count]});
  return links;
}

// The edges that two facets of one plane share. The facets use them in opposite directions.
int shared_edges(Facet a, Facet b) {
  int count = 0;
  if (incidence_of(a) != incidence_of(b)) return count;
  for (const FacetLink& link : links_of(a))
    for (const FacetLink& other : links_of(b))
      count += link.from == other.to && link.to == other.from;
  return count;
}

// The group of each facet of the configuration.
std::vector<uint8_t> number_groups(const std::vector<Facet>& facets) {
  std::vector<uint8_t> label(facets.size());
  for (size_t i = 0; i < label.size(); ++i) label[i] = static_cast<uint8_t>(i);
  for (size_t a = 0; a < facets.size(); ++a)
    for (size_t b = 0; b < a; ++b)
      if (shared_edges(facets[a], facets[b]) > 0)
        std::replace(label.begin(), label.end(), uint8_t{label[a]}, uint8_t{label[b]});
  std::vector<uint8_t> distinct = label;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  for (uint8_t& number : label)
    number = static_cast<uint8_t>(std::lower_bound(distinct.begin(), distinct.end(), number) -
                                  distinct.begin());
  return label;
}

std::vector<Facet> facets_of(int configuration) {
  return {facet_table.facet + facet_table.first[configuration],
          facet_table.facet + facet_table.first[configuration + 1]};
}

// The midpoint of a link, without the coordinate that all links of the face have in common.
uint8_t place_on(int face, const FacetLink& link) {
  Vertex middle = position(link.from) + position(link.to);
  if (face % 3 == 0) middle.x = 0;
  if (face % 3 == 1) middle.y = 0;
  if (face % 3 == 2) middle.z = 0;
  return static_cast<uint8_t>(middle.x + 5 * middle.y + 25 * middle.z);
}

CellGroups groups_of(int configuration) {
  CellGroups groups{};
  const std::vector<Facet> facets = facets_of(configuration);
  const std::vector<uint8_t> number = number_groups(facets);
  for (size_t i = 0; i < facets.size(); ++i) {
    groups.count = std::max(groups.count, static_cast<uint8_t>(number[i] + 1));
    groups.incidence[number[i]] = incidence_of(facets[i]);
    groups.links = static_cast<uint8_t>(groups.links + links_of(facets[i]).size());
    for (size_t other = 0; other < i; ++other)
      groups.links =
          static_cast<uint8_t>(groups.links - 2 * shared_edges(facets[i], facets[other]));
    for (const FacetLink& link : links_of(facets[i])) {
      const int face = face_of(link.from, link.to);
      if (face != faces)
        groups.link[face][groups.face_links[face]++] = {place_on(face, link), number[i]};
    }
  }
  for (int face = 0; face < faces; ++face)
    std::sort(groups.link[face], groups.link[face] + groups.face_links[face],
              [](const auto& a, const auto& b) { return a.place < b.place; });
  return groups;
}

uint64_t hash_of(const Vertex& origin, Facet facet) {
  uint64_t sum = 0;
  for (const FacetLink& link : links_of(facet))
    sum += reference::link_hash(origin + position(link.from), origin + position(link.to));
  return reference::of_incidence(sum, incidence_of(facet));
}

}  // namespace

GroupTable::GroupTable(int32_t side, int32_t first)
    : side_(side), hashes_(cell(0, 0, side) * configurations) {
  for (int c = 0; c < configurations; ++c) {
    groups_[static_cast<size_t>(c)] = groups_of(c);
    const std::vector<Facet> facets = facets_of(c);
    const std::vector<uint8_t> number = number_groups(facets);
    for (size_t at = 0; at < cell(0, 0, side); ++at) {
      const auto i = static_cast<int32_t>(at);
      const Vertex origin{2 * (first + i % side), 2 * (first + i / side % side),
                          2 * (first + i / side / side)};
      for (size_t f = 0; f < facets.size(); ++f)
        hashes_[at * configurations + static_cast<size_t>(c)][number[f]] +=
            hash_of(origin, facets[f]);
    }
  }
}

Forest::Forest(const GroupTable& table)
    : table_(table),
      cells_(table.cell(0, 0, table.side())),
      nodes_of_(cells_.size() * CellGroups::max_groups),
      united_(nodes_of_.size()) {}

void Forest::add(int32_t x, int32_t y, int32_t z, Configuration configuration) {
  const size_t at = table_.cell(x, y, z);
  const CellGroups& groups = table_.groups(configuration);
  const Placed cell{configuration, nodes_};
  cells_[at] = cell;
  for (int group = 0; group < groups.count; ++group) {
    const uint64_t hash = table_.hash(at, configuration, group);
    nodes_of_[nodes_] = {nodes_, groups.incidence[group], hash};
    fingerprint_ += reference::mix(hash);
    ++nodes_;
  }
  links_ += groups.links;
  if (x > 0) join_across(face_left, cell, cells_[table_.cell(x - 1, y, z)]);
  if (y > 0) join_across(face_front, cell, cells_[table_.cell(x, y - 1, z)]);
  if (z > 0) join_across(face_below, cell, cells_[table_.cell(x, y, z - 1)]);
}

// Both cells list the same links in the same order, because they share the corners of the face.
void Forest::join_across(Face face, const Placed& cell, const Placed& behind) {
  const CellGroups& groups = table_.groups(cell.configuration);
  const CellGroups& others = table_.groups(behind.configuration);
  for (int i = 0; i < groups.face_links[face]; ++i) {
    const uint32_t node = cell.first_node + groups.link[face][i].group;
    const uint32_t other = behind.first_node + others.link[face + 3][i].group;
    if (nodes_of_[node].incidence != nodes_of_[other].incidence) continue;
    links_ -= 2;
    unite(root(other), root(node));
  }
}

void Forest::unite(uint32_t a, uint32_t b) {
  if (a == b) return;
  Node& root = nodes_of_[a];
  Node& child = nodes_of_[b];
  fingerprint_ -= reference::mix(root.hash) + reference::mix(child.hash);
  child.parent = a;
  root.hash += child.hash;
  fingerprint_ += reference::mix(root.hash);
  united_[unions_++] = b;
}

void Forest::go_back(const Mark& mark) {
  while (unions_ > mark.unions) {
    Node& child = nodes_of_[united_[--unions_]];
    nodes_of_[child.parent].hash -= child.hash;
    child.parent = united_[unions_];
  }
  nodes_ = mark.nodes;
  links_ = mark.links;
  fingerprint_ = mark.fingerprint;
}

}  // namespace discmc::prove
