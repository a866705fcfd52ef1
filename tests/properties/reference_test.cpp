// Properties of the surface of any volume, tested on the paper's Merge.
#include "oracle/merge.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

struct Named {
  const char* name;
  BitVolume volume;
};

std::vector<Named> hostile_and_plain_volumes() {
  return {{"lone voxel", from_bits({1, 1, 1}, 1)},
          {"all on", box({5, 4, 3}, {0, 0, 0}, {4, 3, 2})},
          {"all off", BitVolume({5, 4, 3})},
          {"box", box({7, 6, 5}, {1, 2, 1}, {5, 4, 3})},
          {"ball", ball({17, 17, 17}, {16, 16, 16}, 50)},
          {"ball at the border", ball({9, 9, 9}, {1, 3, 8}, 40)},
          {"torus", torus({28, 28, 12}, 18, 7)},
          {"checkerboard", checkerboard({7, 6, 5})},
          {"columns", columns({7, 6, 5})},
          {"tiling of 61", tiling_61({9, 8, 7})},
          {"comb", comb({9, 8, 3})},
          {"spiral", spiral({15, 15, 3})},
          {"sparse", random({16, 15, 14}, 30, 1)},
          {"random", random({16, 15, 14}, 128, 2)},
          {"dense", random({16, 15, 14}, 226, 3)}};
}

// Includes all ways to fill 2 x 2 x 2 voxels, alone and repeated, so that all configurations are
// adjacent.
template <typename Check>
void for_each_volume(Check check) {
  for (const Named& named : hostile_and_plain_volumes()) {
    CAPTURE(named.name);
    check(named.volume);
  }
  for (int c = 0; c < configurations; ++c) {
    CAPTURE(c);
    check(from_bits({2, 2, 2}, static_cast<uint64_t>(c)));
    check(tiling({5, 5, 5}, static_cast<Configuration>(c)));
  }
}

struct LinkBefore {
  bool operator()(const std::pair<Vertex, Vertex>& a, const std::pair<Vertex, Vertex>& b) const {
    return a.first == b.first ? before(a.second, b.second) : before(a.first, b.first);
  }
};

// Returns how often each link occurs forwards minus backwards, without zeros.
using LinkSum = std::map<std::pair<Vertex, Vertex>, int, LinkBefore>;

void add_link(LinkSum& sum, const Vertex& from, const Vertex& to) {
  const bool is_forward = before(from, to);
  const auto entry =
      sum.try_emplace(is_forward ? std::pair(from, to) : std::pair(to, from), 0).first;
  entry->second += is_forward ? 1 : -1;
  if (entry->second == 0) sum.erase(entry);
}

LinkSum sum_of_links(const std::vector<Region>& regions) {
  LinkSum sum;
  for (const Region& region : regions)
    for (const Ring& ring : region.rings)
      for (size_t i = 0; i < ring.size(); ++i) add_link(sum, ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

// Returns twice the area, times the normal's length, by signed plane: incidence and n.p.
using PlaneAreas = std::map<std::pair<Incidence, int64_t>, int64_t>;

PlaneAreas areas_of(const std::vector<Region>& regions) {
  PlaneAreas areas;
  for (const Region& region : regions)
    for (const Ring& ring : region.rings)
      areas[{region.incidence, dot_product(incidence_normal(region.incidence), ring[0])}] +=
          signed_area(region.incidence, ring);
  return areas;
}

PlaneAreas areas_of_facets(const BitVolume& volume, bool is_closed) {
  PlaneAreas areas;
  for_each_cell(volume, is_closed, [&](const Vertex& cell, Configuration configuration) {
    for (int i = facet_table.first[configuration]; i < facet_table.first[configuration + 1]; ++i) {
      const Facet facet = facet_table.facet[i];
      const FacetRing& points = facet_rings.ring[facet];
      Ring ring;
      for (int p = 0; p < points.count; ++p)
        ring.push_back(cell + cell + position(points.point[p]));
      const Incidence incidence = incidence_of(facet);
      areas[{incidence, dot_product(incidence_normal(incidence), ring[0])}] +=
          signed_area(incidence, ring);
    }
  });
  return areas;
}

bool is_simple(Ring ring) {
  std::sort(ring.begin(), ring.end(), before);
  return std::adjacent_find(ring.begin(), ring.end()) == ring.end();
}

bool is_flat(const Region& region) {
  const Vertex n = incidence_normal(region.incidence);
  const int32_t plane = dot_product(n, region.rings[0][0]);
  for (const Ring& ring : region.rings)
    for (const Vertex& vertex : ring)
      if (dot_product(n, vertex) != plane) return false;
  return true;
}

int rings_counter_clockwise(const Region& region) {
  int count = 0;
  for (const Ring& ring : region.rings) count += signed_area(region.incidence, ring) > 0;
  return count;
}

}  // namespace

TEST_CASE("the directed links of a closed surface cancel in opposite pairs") {
  for_each_volume(
      [](const BitVolume& volume) { CHECK(sum_of_links(merge(volume, true)).empty()); });
}

TEST_CASE("unpaired links of an open border occur only at the ends of the volume") {
  for_each_volume([](const BitVolume& volume) {
    const auto on_border = [](int32_t a, int32_t b, uint32_t voxels) {
      return a == b && (a == 0 || a == 2 * static_cast<int32_t>(voxels) - 2);
    };
    int inside = 0;
    for (const auto& [link, times] : sum_of_links(merge(volume, false))) {
      const auto& [from, to] = link;
      inside += !on_border(from.x, to.x, volume.width) && !on_border(from.y, to.y, volume.height) &&
                !on_border(from.z, to.z, volume.depth);
    }
    CHECK(inside == 0);
  });
}

TEST_CASE("polygons and cells enclose the same volume") {
  for_each_volume([](const BitVolume& volume) {
    const Counts counted = counts(volume, true, merge(volume, true));
    CHECK(counted.enclosed == counted.six_volumes);
  });
}

TEST_CASE("merging preserves the area of the surface on every plane") {
  for_each_volume([](const BitVolume& volume) {
    for (const bool is_closed : {true, false})
      CHECK(areas_of(merge(volume, is_closed)) == areas_of_facets(volume, is_closed));
  });
}

TEST_CASE("a region is flat, its rings are simple, and only the first is counter-clockwise") {
  for_each_volume([](const BitVolume& volume) {
    for (const Region& region : merge(volume, true)) {
      CHECK(is_flat(region));
      CHECK(std::all_of(region.rings.begin(), region.rings.end(), is_simple));
      CHECK(signed_area(region.incidence, region.rings[0]) > 0);
      CHECK(rings_counter_clockwise(region) == 1);
    }
  });
}

TEST_CASE("a region is maximal: its plane does not continue across its boundary") {
  for_each_volume([](const BitVolume& volume) {
    std::map<Incidence, std::vector<Region>> by_incidence;
    for (const Region& region : merge(volume, true))
      by_incidence[region.incidence].push_back(region);
    for (const auto& [incidence, regions] : by_incidence) {
      size_t link_count = 0;
      for (const Region& region : regions)
        for (const Ring& ring : region.rings) link_count += ring.size();
      // If a link and its opposite were both present, they would cancel in the sum.
      CHECK(sum_of_links(regions).size() == link_count);
    }
  });
}

TEST_CASE("a closed border reaches from -1 to 2W-1, and an open border from 0 to 2W-2") {
  const BitVolume volume = checkerboard({7, 6, 5});
  for (const bool is_closed : {true, false}) {
    Vertex least{99, 99, 99};
    Vertex greatest{-99, -99, -99};
    for (const Region& region : merge(volume, is_closed))
      for (const Vertex& vertex : region.rings[0]) {
        least = {std::min(least.x, vertex.x), std::min(least.y, vertex.y),
                 std::min(least.z, vertex.z)};
        greatest = {std::max(greatest.x, vertex.x), std::max(greatest.y, vertex.y),
                    std::max(greatest.z, vertex.z)};
      }
    CHECK(least == (is_closed ? Vertex{-1, -1, -1} : Vertex{0, 0, 0}));
    CHECK(greatest == (is_closed ? Vertex{13, 11, 9} : Vertex{12, 10, 8}));
  }
}

TEST_CASE("the rings of a region that touches itself are simple") {
  bool touches = false;
  for (uint64_t seed = 0; seed < 20; ++seed)
    for (const Region& region : merge(random({24, 24, 3}, 200, seed), true)) {
      Ring all;
      for (const Ring& ring : region.rings) {
        CHECK(is_simple(ring));
        all.insert(all.end(), ring.begin(), ring.end());
      }
      touches = touches || !is_simple(all);
    }
  CHECK_MESSAGE(touches, "the volumes are to show the case");
}

TEST_CASE("the canonical form ignores the starts and the order of rings") {
  const std::vector<Region> merged = merge(random({12, 12, 6}, 200, 7), true);
  const std::vector<Region> expected = canonical(merged);
  std::vector<Region> shuffled = merged;
  std::reverse(shuffled.begin(), shuffled.end());
  for (Region& region : shuffled) {
    std::reverse(region.rings.begin() + 1, region.rings.end());
    for (Ring& ring : region.rings) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }
  CHECK(shuffled != merged);
  CHECK(canonical(shuffled) == expected);
  CHECK(describe_difference(canonical(shuffled), expected) == "");
}

TEST_CASE("describe_difference() describes the first region that differs") {
  const std::vector<Region> voxel = canonical(merge(from_bits({1, 1, 1}, 1), true));
  std::vector<Region> other = voxel;
  other[3].rings[0][1].z = 77;
  const std::string text = describe_difference(voxel, other);
  CHECK(text.find("region 3") != std::string::npos);
  CHECK(text.find("77") != std::string::npos);
  other = voxel;
  other.pop_back();
  CHECK(describe_difference(voxel, other).find("nothing more") != std::string::npos);
}

TEST_CASE("a table with a single wrong facet is detected") {
  FacetTable wrong = facet_table;
  const int first = wrong.first[1];
  wrong.facet[first] = facet_of(incidence_of(wrong.facet[first]), 2);
  CHECK_FALSE(sum_of_links(merge(from_bits({1, 1, 1}, 1), true, wrong)).empty());
}
