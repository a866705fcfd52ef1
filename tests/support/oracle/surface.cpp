#include "surface.hpp"

#include "facet_neighbours.hpp"

namespace discmc::reference {

uint64_t mix(uint64_t value) {
  return next_random(value);
}

// The middle of a unit link in quarter-steps also determines its axis, except for its sign.
uint64_t link_hash(const Vertex& from, const Vertex& to) {
  const Vertex middle = from + to;
  const Vertex step = to - from;
  const auto bits = [](int32_t coordinate) { return static_cast<uint64_t>(coordinate + 4); };
  const uint64_t place = bits(middle.z) << 40 ^ bits(middle.y) << 20 ^ bits(middle.x);
  const bool is_forward = before(from, to);
  const Vertex along = is_forward ? step : -step;
  const uint64_t hash =
      mix(mix(place) ^ (bits(along.z) << 16 ^ bits(along.y) << 8 ^ bits(along.x)));
  return is_forward ? hash : 0 - hash;
}

uint64_t of_incidence(uint64_t link, Incidence incidence) {
  return link * (mix(incidence) | 1);
}

namespace {

void add_ring(Surface& surface, Incidence incidence, const Ring& ring) {
  uint64_t links = 0;
  for (size_t i = 0; i < ring.size(); ++i)
    links += link_hash(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  const int64_t area = signed_area(incidence, ring);
  const int64_t offset = dot_product(incidence_normal(incidence), ring[0]);
  surface.boundary += of_incidence(links, incidence);
  surface.open_links += links;
  surface.areas +=
      static_cast<uint64_t>(area) * mix(mix(static_cast<uint64_t>(offset)) ^ incidence);
  surface.six_volumes +=
      area / dot_product(incidence_normal(incidence), incidence_normal(incidence)) * offset;
}

Ring ring_of(const Vertex& cell, Facet facet) {
  const FacetRing& points = facet_rings.ring[facet];
  Ring ring;
  for (int p = 0; p < points.count; ++p) ring.push_back(cell + cell + position(points.point[p]));
  return ring;
}

// The facets of a small volume, in a union-find forest.
class FacetForest {
 public:
  FacetForest(const BitVolume& volume, bool is_closed)
      : columns_(volume.width + 1), rows_(volume.height + 1) {
    number_.resize(columns_ * rows_ * (volume.depth + 1) * facet_codes, 0);
    for_each_cell(volume, is_closed, [&](const Vertex& cell, Configuration configuration) {
      for (int i = facet_table.first[configuration]; i < facet_table.first[configuration + 1]; ++i)
        add(cell, facet_table.facet[i]);
    });
  }

  uint64_t fingerprint() {
    for (uint32_t i = 0; i < facets_.size(); ++i) join_neighbours(i);
    std::vector<uint64_t> sums(facets_.size());
    for (uint32_t i = 0; i < facets_.size(); ++i) sums[root(i)] += hash_of(facets_[i]);
    uint64_t sum = 0;
    for (uint32_t i = 0; i < facets_.size(); ++i)
      if (root(i) == i) sum += mix(sums[i]);
    return sum;
  }

 private:
  struct Placed {
    Vertex cell;
    Facet facet;
  };

  size_t place(const Vertex& cell, Facet facet) const {
    const auto at = [](int32_t coordinate) { return static_cast<size_t>(coordinate + 1); };
    return ((at(cell.z) * rows_ + at(cell.y)) * columns_ + at(cell.x)) * facet_codes + facet;
  }

  void add(const Vertex& cell, Facet facet) {
    parent_.push_back(static_cast<uint32_t>(facets_.size()));
    facets_.push_back({cell, facet});
    number_[place(cell, facet)] = static_cast<uint32_t>(facets_.size());
  }

  uint32_t root(uint32_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }

  bool contains(const Vertex& cell) const {
    return cell.x >= -1 && cell.y >= -1 && cell.z >= -1 &&
           cell.x + 1 < static_cast<int64_t>(columns_) &&
           cell.y + 1 < static_cast<int64_t>(rows_) && place(cell, 0) < number_.size();
  }

  void join_neighbours(uint32_t i) {
    const Placed facet = facets_[i];
    for (int edge = 0; edge < facet_rings.ring[facet.facet].count; ++edge) {
      const Neighbour& neighbour = tabulated_neighbour(facet.facet, edge);
      const Vertex cell = facet.cell + neighbour.cell;
      const uint32_t other = contains(cell) ? number_[place(cell, neighbour.facet)] : 0;
      if (other != 0) parent_[root(other - 1)] = root(i);
    }
  }

  static uint64_t hash_of(const Placed& facet) {
    const FacetRing& points = facet_rings.ring[facet.facet];
    const Vertex origin = facet.cell + facet.cell;
    uint64_t links = 0;
    for (int p = 0; p < points.count; ++p)
      links += link_hash(origin + position(points.point[p]),
                         origin + position(points.point[p + 1 < points.count ? p + 1 : 0]));
    return of_incidence(links, incidence_of(facet.facet));
  }

  size_t columns_, rows_;
  std::vector<uint32_t> number_;  // by place: the facet's number plus one, 0 for none
  std::vector<Placed> facets_;
  std::vector<uint32_t> parent_;
};

}  // namespace

bool operator==(const Surface& a, const Surface& b) {
  return a.boundary == b.boundary && a.open_links == b.open_links && a.areas == b.areas &&
         a.six_volumes == b.six_volumes;
}

Surface surface_of(const std::vector<Region>& regions) {
  Surface surface{};
  for (const Region& region : regions)
    for (const Ring& ring : region.rings) add_ring(surface, region.incidence, ring);
  return surface;
}

Surface surface_of_cells(const BitVolume& volume, bool is_closed) {
  Surface surface{};
  for_each_cell(volume, is_closed, [&](const Vertex& cell, Configuration configuration) {
    for (int i = facet_table.first[configuration]; i < facet_table.first[configuration + 1]; ++i) {
      const Facet facet = facet_table.facet[i];
      add_ring(surface, incidence_of(facet), ring_of(cell, facet));
    }
  });
  return surface;
}

uint64_t fingerprint(const std::vector<Region>& regions) {
  uint64_t sum = 0;
  for (const Region& region : regions) {
    Surface surface{};
    for (const Ring& ring : region.rings) add_ring(surface, region.incidence, ring);
    sum += mix(surface.boundary);
  }
  return sum;
}

uint64_t fingerprint_of_cells(const BitVolume& volume, bool is_closed) {
  return FacetForest(volume, is_closed).fingerprint();
}

}  // namespace discmc::reference
