#include "region.hpp"

#include <algorithm>
#include <tuple>

namespace discmc::reference {

namespace {

bool ring_before(const Ring& a, const Ring& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
}

bool region_before(const Region& a, const Region& b) {
  if (a.incidence != b.incidence) return a.incidence < b.incidence;
  return std::lexicographical_compare(a.rings.begin(), a.rings.end(), b.rings.begin(),
                                      b.rings.end(), ring_before);
}

// A vertex may recur in a ring of a sweep, a directed link never. So the ring begins at its
// smallest vertex; if that recurs, the smaller next vertex decides.
void rotate_to_smallest(Ring& ring) {
  size_t smallest = 0;
  for (size_t i = 1; i < ring.size(); ++i) {
    const Vertex& next = ring[(i + 1) % ring.size()];
    const bool is_smaller = ring[i] == ring[smallest] ? before(next, ring[smallest + 1])
                                                      : before(ring[i], ring[smallest]);
    if (is_smaller) smallest = i;
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(smallest), ring.end());
}

std::string describe(const Vertex& vertex) {
  return '(' + std::to_string(vertex.x) + ", " + std::to_string(vertex.y) + ", " +
         std::to_string(vertex.z) + ')';
}

std::string describe(const Region& region) {
  std::string text = "incidence " + describe(incidence_normal(region.incidence));
  for (const Ring& ring : region.rings) {
    constexpr size_t shown = 12;
    text += "; ring of " + std::to_string(ring.size()) + " links:";
    for (size_t i = 0; i < std::min(ring.size(), shown); ++i) text += ' ' + describe(ring[i]);
    if (ring.size() > shown) text += " ...";
  }
  return text;
}

// The sum of cross products of neighbouring vertices: twice the area, along the normal.
struct Area {
  int64_t x, y, z;
};

Area twice_area(const Ring& ring) {
  Area sum{0, 0, 0};
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vertex& a = ring[i];
    const Vertex& b = ring[(i + 1) % ring.size()];
    sum.x += int64_t{a.y} * b.z - int64_t{a.z} * b.y;
    sum.y += int64_t{a.z} * b.x - int64_t{a.x} * b.z;
    sum.z += int64_t{a.x} * b.y - int64_t{a.y} * b.x;
  }
  return sum;
}

}  // namespace

bool before(const Vertex& a, const Vertex& b) {
  return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

bool operator==(const Region& a, const Region& b) {
  return a.incidence == b.incidence && a.rings == b.rings;
}

std::vector<Region> canonical(std::vector<Region> regions) {
  for (Region& region : regions) {
    for (Ring& ring : region.rings) rotate_to_smallest(ring);
    if (!region.rings.empty()) std::sort(region.rings.begin() + 1, region.rings.end(), ring_before);
  }
  std::sort(regions.begin(), regions.end(), region_before);
  return regions;
}

std::string describe_difference(const std::vector<Region>& a, const std::vector<Region>& b) {
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (in_a == a.end() && in_b == b.end()) return {};
  return std::to_string(a.size()) + " and " + std::to_string(b.size()) +
         " regions, different from region " + std::to_string(in_a - a.begin()) +
         " on.\n  a: " + (in_a == a.end() ? "nothing more" : describe(*in_a)) +
         "\n  b: " + (in_b == b.end() ? "nothing more" : describe(*in_b));
}

int64_t signed_area(Incidence incidence, const Ring& ring) {
  const Area area = twice_area(ring);
  const Vertex n = incidence_normal(incidence);
  return area.x * n.x + area.y * n.y + area.z * n.z;
}

Counts counts(const BitVolume& volume, bool is_closed, const std::vector<Region>& regions) {
  Counts counts{};
  for_each_cell(volume, is_closed, [&](const Vertex&, Configuration configuration) {
    counts.facets += cell_facts.facets[configuration];
    counts.classic_triangles += cell_facts.classic_triangles[configuration];
    counts.enclosed += cell_facts.enclosed[configuration];
  });
  for (const Region& region : regions) {
    ++counts.regions;
    counts.rings += static_cast<int64_t>(region.rings.size());
    counts.holes += static_cast<int64_t>(region.rings.size()) - 1;
    for (const Ring& ring : region.rings) {
      const Area area = twice_area(ring);
      counts.links += static_cast<int64_t>(ring.size());
      counts.six_volumes += area.x * ring[0].x + area.y * ring[0].y + area.z * ring[0].z;
    }
  }
  return counts;
}

}  // namespace discmc::reference
