#include "table_statements.hpp"

#include <algorithm>
#include <array>
#include <discmc/stream/crc32.hpp>
#include <iterator>
#include <vector>

#include "region.hpp"

namespace discmc::reference {

namespace {

struct PointLink {
  CellPoint from, to;
};

bool operator==(const PointLink& a, const PointLink& b) {
  return a.from == b.from && a.to == b.to;
}
bool operator<(const PointLink& a, const PointLink& b) {
  return a.from == b.from ? a.to < b.to : a.from < b.from;
}

// A few links, because a cell has at most seven facets of four links.
class LinkList {
 public:
  // A link and its opposite cancel.
  void add(const PointLink& link) {
    const auto opposite = std::find(links_.begin(), end(), PointLink{link.to, link.from});
    if (opposite == end())
      links_[count_++] = link;
    else
      *opposite = links_[--count_];
  }
  void add(const CellPoint* points, int count) {
    for (int i = 0; i < count; ++i) add({points[i], points[(i + 1) % count]});
  }
  void sort() { std::sort(links_.begin(), end()); }
  bool operator==(const LinkList& other) const {
    return count_ == other.count_ && std::equal(links_.begin(), end(), other.links_.begin());
  }

 private:
  using Links = std::array<PointLink, 32>;
  Links::const_iterator end() const { return links_.begin() + count_; }
  Links::iterator end() { return links_.begin() + count_; }

  Links links_{};
  uint8_t count_ = 0;
};

bool is_incidence(int code) {
  return code < incidence_codes && code != no_incidence;
}

int squared_length(const Vertex& vector) {
  return dot_product(vector, vector);
}

bool is_surface_point(CellPoint point) {
  const Vertex p = position(point);
  const bool is_inside = p.x <= 2 && p.y <= 2 && p.z <= 2;
  return is_inside && (point == centroid || p.x % 2 + p.y % 2 + p.z % 2 == 1);
}

const Loops& loops_of(int configuration) {
  static const std::vector<Loops> all = [] {
    std::vector<Loops> loops;
    for (int c = 0; c < configurations; ++c)
      loops.push_back(detail::derive::loops(static_cast<Configuration>(c)));
    return loops;
  }();
  return all[static_cast<size_t>(configuration)];
}

// ---- links ----

bool is_link(const Vertex& vector) {
  const int length = squared_length(vector);
  const bool is_odd = ((vector.x | vector.y | vector.z) & 1) != 0;
  return length == 2 || (length == 4 && !is_odd);
}

bool are_links_in_order(const LinkTable& links) {
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex vector = detail::derive::link_vector(links, link);
    if (!is_link(vector)) return false;
    if (link > 0 &&
        !before(detail::derive::link_vector(links, static_cast<Link>(link - 1)), vector))
      return false;
  }
  return true;
}

bool counts_directions(const LinkTable& links) {
  constexpr int by_squared_length[] = {0, 8, 4, 6};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    if (links.direction_count[incidence] !=
        by_squared_length[squared_length(incidence_normal(incidence))])
      return false;
  return true;
}

// Directions cover half a round: each is less than half a turn from the first, and beyond the
// previous one.
bool turns_counter_clockwise(const LinkTable& links, Incidence incidence) {
  const Vertex n = incidence_normal(incidence);
  const Link* half = links.link[incidence];
  if (half[0] >= link_codes || dot_product(detail::derive::link_vector(links, half[0]), n) != 0)
    return false;
  for (int i = 1; i < links.direction_count[incidence] / 2; ++i) {
    if (half[i] >= link_codes) return false;
    const Vertex vector = detail::derive::link_vector(links, half[i]);
    if (dot_product(vector, n) != 0) return false;
    for (int earlier = 0; earlier < i; ++earlier)
      if (dot_product(cross(detail::derive::link_vector(links, half[earlier]), vector), n) <= 0)
        return false;
  }
  return true;
}

bool begins_with_lowest(const LinkTable& links, Incidence incidence) {
  for (Link link = 0; link < links.link[incidence][0]; ++link)
    if (dot_product(detail::derive::link_vector(links, link), incidence_normal(incidence)) == 0)
      return false;
  return true;
}

// ---- facets ----

bool is_partition(const FacetTable& table) {
  if (table.first[0] != 0 || table.first[configurations] != FacetTable::total) return false;
  for (int c = 0; c < configurations; ++c) {
    if (table.first[c + 1] > FacetTable::total || table.first[c] > table.first[c + 1]) return false;
    if (table.first[c + 1] - table.first[c] > 7) return false;
  }
  return true;
}

bool is_ring(const FacetRing& ring) {
  if (ring.count != 3 && ring.count != 4) return false;
  return std::all_of(ring.point, ring.point + ring.count, is_surface_point);
}

bool has_rings_of_its_facets(const FacetTables& facets) {
  std::array<bool, facet_codes> occurs{};
  for (const Facet facet : facets.table.facet) occurs[facet] = true;
  for (size_t code = 0; code < facet_codes; ++code)
    if (occurs[code] ? !is_ring(facets.rings.ring[code]) : facets.rings.ring[code].count != 0)
      return false;
  return true;
}

// The corners are counter-clockwise about the normal at every point.
bool lies_as_its_code_says(const FacetRing& ring, Facet facet) {
  if (!is_incidence(incidence_of(facet))) return false;
  const Vertex n = incidence_normal(incidence_of(facet));
  for (int i = 0; i < ring.count; ++i) {
    const Vertex a = position(ring.point[i]);
    const Vertex b = position(ring.point[(i + 1) % ring.count]);
    const Vertex c = position(ring.point[(i + 2) % ring.count]);
    if (dot_product(n, b - a) != 0 || dot_product(n, cross(b - a, c - b)) <= 0) return false;
  }
  return true;
}

bool fills_the_loops(const FacetTables& facets, int configuration) {
  LinkList links;
  for (int i = facets.table.first[configuration]; i < facets.table.first[configuration + 1]; ++i) {
    const FacetRing& ring = facets.rings.ring[facets.table.facet[i]];
    links.add(ring.point, ring.count);
  }
  LinkList expected;
  const Loops& loops = loops_of(configuration);
  for (int l = 0; l < loops.count; ++l) expected.add(loops.loop[l].point, loops.loop[l].count);
  links.sort();
  expected.sort();
  return links == expected;
}

int classic_triangles(int configuration) {
  const Loops& loops = loops_of(configuration);
  int triangles = 0;
  for (int l = 0; l < loops.count; ++l) triangles += loops.loop[l].count - 2;
  return triangles;
}

// Returns the volume as a sum of pyramids with their tips at corner 0. Their bases are the facets
// and the on parts of the three faces that do not meet there. Units: 48ths of a cell.
int enclosed(const FacetTables& facets, int configuration) {
  constexpr int twice_on_area[] = {0, 1, 4, 7, 8};
  int sum = 0;
  for (const int face : {face_right, face_back, face_above}) {
    const detail::derive::FaceCorners ring = detail::derive::face_corners(face);
    bool on[4] = {};
    int count = 0;
    for (int i = 0; i < 4; ++i) count += on[i] = (configuration >> ring.corner[i] & 1) != 0;
    sum += 2 * (count == 2 && on[0] == on[2] ? 2 : twice_on_area[count]);
  }
  for (int i = facets.table.first[configuration]; i < facets.table.first[configuration + 1]; ++i) {
    const FacetRing& ring = facets.rings.ring[facets.table.facet[i]];
    for (int p = 2; p < ring.count; ++p)
      sum += dot_product(position(ring.point[0]),
                         cross(position(ring.point[p - 1]), position(ring.point[p])));
  }
  return sum;
}

bool states_the_facts(const FacetTables& facets, int configuration) {
  const int count = facets.table.first[configuration + 1] - facets.table.first[configuration];
  return facets.facts.facets[configuration] == count &&
         facets.facts.classic_triangles[configuration] == classic_triangles(configuration) &&
         facets.facts.enclosed[configuration] == enclosed(facets, configuration);
}

}  // namespace

const char* broken(const LinkTable& links) {
  if (!are_links_in_order(links)) return "the 18 links are numbered by z, y, x";
  if (!counts_directions(links)) return "axis planes have 8 directions, diagonal 4, corner 6";
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    if (incidence == no_incidence) continue;
    if (!turns_counter_clockwise(links, incidence))
      return "the directions of a plane go round counter-clockwise";
    if (!begins_with_lowest(links, incidence)) return "direction 0 is the lowest link of the plane";
  }
  return nullptr;
}

const char* broken(const FacetTables& facets) {
  if (!is_partition(facets.table)) return "every facet belongs to a configuration";
  if (!has_rings_of_its_facets(facets)) return "a code has a ring exactly if it occurs";
  for (size_t code = 0; code < facet_codes; ++code) {
    const FacetRing& ring = facets.rings.ring[code];
    if (ring.count != 0 && !lies_as_its_code_says(ring, static_cast<Facet>(code)))
      return "a facet is flat and counter-clockwise about the normal of its code";
  }
  for (int c = 0; c < configurations; ++c) {
    if (!fills_the_loops(facets, c)) return "the facets of a cell leave its loops over";
    if (!states_the_facts(facets, c)) return "facets, triangles and volume of a cell";
  }
  return nullptr;
}

FacetTables facet_tables() {
  return {facet_table, facet_rings, cell_facts};
}

ModelTable model_table() {
  ModelTable model;
  std::copy(std::begin(detail::stream::cumulative_frequencies),
            std::end(detail::stream::cumulative_frequencies), model.frequencies);
  return model;
}

// Other numbers change the format: they need a new detail::wire::version, new golden files, and a
// new WIRE.md.
const char* broken(const ModelTable& model) {
  const uint32_t version_1 = 0x2725C136;
  return crc32(model.frequencies, sizeof(model.frequencies)) == version_1
             ? nullptr
             : "the frequencies are those of version 1";
}

}  // namespace discmc::reference
