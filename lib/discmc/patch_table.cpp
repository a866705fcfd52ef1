#include <discmc/patch_table.hpp>

namespace discmc {

namespace {

// A patch on its way into the table.
struct LinkRing {
  Patch::Kind kind;
  Incidence incidence;
  Point start;
  uint8_t count;
  uint8_t link[Patch::max_links];
};

constexpr bool operator==(const LinkRing& a, const LinkRing& b) {
  if (a.incidence != b.incidence || a.start != b.start || a.count != b.count) return false;
  for (int i = 0; i < a.count; ++i)
    if (a.link[i] != b.link[i]) return false;
  return true;
}

// A ring of points that becomes a patch.
struct PointRing {
  uint8_t count;
  Point point[Patch::max_links];
};

constexpr int sign(int value) {
  return (value > 0) - (value < 0);
}

constexpr Incidence plane_of(Point a, Point b, Point c) {
  const Vertex n = cross(position(b) - position(a), position(c) - position(a));
  return incidence_of(Vertex{sign(n.x), sign(n.y), sign(n.z)});
}

constexpr bool is_flat(const Loop& loop) {
  const Vertex n = normal(plane_of(loop.point[0], loop.point[1], loop.point[2]));
  for (int i = 3; i < loop.count; ++i)
    if (dot(n, position(loop.point[i]) - position(loop.point[0])) != 0) return false;
  return true;
}

constexpr uint8_t coded_link(Incidence incidence, Point from, Point to) {
  const Direction direction = direction_of(incidence, position(to) - position(from));
  const int face = face_of(from, to);
  const int place = face == faces ? spoke : 2 * face + place_in_face(from, to);
  return static_cast<uint8_t>(place << 3 | direction);
}

// Of the flat loops the corner triangle and the rectangle are one facet each.
constexpr Patch::Kind kind_of(Incidence incidence, const PointRing& ring) {
  for (int i = 0; i < ring.count; ++i)
    if (ring.point[i] == centroid) return Patch::Kind::sectors;
  const Vertex n = normal(incidence);
  const bool is_rectangle = ring.count == 4 && dot(n, n) == 2;
  return ring.count == 3 || is_rectangle ? Patch::Kind::facet : Patch::Kind::fan;
}

// Starts the ring at a link ahead where there is one, so that the merge begins with an open edge.
constexpr LinkRing patch_of(Incidence incidence, const PointRing& ring) {
  int start = 0;
  for (int i = 0; i < ring.count; ++i) {
    const uint8_t link = coded_link(incidence, ring.point[i], ring.point[(i + 1) % ring.count]);
    if (!is_ahead(link >> 3)) continue;
    start = i;
    break;
  }
  LinkRing patch{kind_of(incidence, ring), incidence, ring.point[start], ring.count, {}};
  for (int i = 0; i < ring.count; ++i) {
    const Point from = ring.point[(start + i) % ring.count];
    const Point to = ring.point[(start + i + 1) % ring.count];
    patch.link[i] = coded_link(incidence, from, to);
  }
  return patch;
}

struct Derived {
  PatchTable table;
  LinkRing patch[PatchTable::distinct];
  CellBounds bounds;
  int total;
  int distinct;
  bool one_patch_an_incidence;
  bool one_fan_a_cell;
};

constexpr void add_patch(Derived& derived, const LinkRing& patch) {
  int index = 0;
  while (index < derived.distinct && !(derived.patch[index] == patch)) ++index;
  if (index == derived.distinct) derived.patch[derived.distinct++] = patch;
  derived.table.index[derived.total++] = static_cast<uint8_t>(index);
}

// The fan's sectors of one incidence, from sector `first` on: their outer links and two spokes.
constexpr PointRing sector_ring(const Loop& loop, int first, int sectors) {
  PointRing ring{};
  for (int i = 0; i <= sectors; ++i)
    ring.point[ring.count++] = loop.point[(first + i) % loop.count];
  ring.point[ring.count++] = centroid;
  return ring;
}

constexpr void add_fan(Derived& derived, const Loop& loop) {
  Incidence incidence[Loop::max_points] = {};
  for (int i = 0; i < loop.count; ++i)
    incidence[i] = plane_of(centroid, loop.point[i], loop.point[(i + 1) % loop.count]);
  for (int first = 0; first < loop.count; ++first) {
    if (incidence[first] == incidence[(first + loop.count - 1) % loop.count]) continue;
    int sectors = 1;
    while (incidence[(first + sectors) % loop.count] == incidence[first]) ++sectors;
    add_patch(derived, patch_of(incidence[first], sector_ring(loop, first, sectors)));
  }
}

constexpr void add_loop(Derived& derived, const Loop& loop) {
  if (!is_flat(loop)) return add_fan(derived, loop);
  PointRing ring{};
  for (int i = 0; i < loop.count; ++i) ring.point[ring.count++] = loop.point[i];
  add_patch(derived, patch_of(plane_of(loop.point[0], loop.point[1], loop.point[2]), ring));
}

constexpr int larger(int a, int b) {
  return a > b ? a : b;
}

constexpr void measure_cell(Derived& derived, int c) {
  const uint32_t first = derived.table.first(c);
  const uint32_t end = derived.table.first(c + 1);
  int links = 0, behind = 0, ahead = 0;
  uint32_t incidences = 0;
  for (uint32_t i = first; i < end; ++i) {
    const Patch patch = derived.table.at(i);
    if (incidences >> patch.incidence & 1) derived.one_patch_an_incidence = false;
    incidences |= uint32_t{1} << patch.incidence;
    links += patch.count;
    for (int l = 0; l < patch.count; ++l) {
      behind += is_behind(patch.place(l));
      ahead += is_ahead(patch.place(l));
    }
  }
  CellBounds& bounds = derived.bounds;
  bounds = {larger(bounds.patches, static_cast<int>(end - first)), larger(bounds.links, links),
            larger(bounds.behind_links, behind), larger(bounds.ahead_links, ahead)};
}

constexpr uint8_t below_links(const Derived& derived, int lower) {
  int found = 0;
  for (uint32_t i = derived.table.first(lower); i < derived.table.first(lower + 1); ++i) {
    const Patch patch = derived.table.at(i);
    for (int l = 0; l < patch.count; ++l)
      if (patch.place(l) / 2 == face_below) found |= 1 << patch.place(l) % 2;
  }
  return static_cast<uint8_t>(found);
}

constexpr void begin_configuration(Derived& derived, int c) {
  uint16_t& block = derived.table.block[c / PatchTable::block_size];
  if (c % PatchTable::block_size == 0) block = static_cast<uint16_t>(derived.total);
  derived.table.within[c] = static_cast<uint8_t>(derived.total - block);
}

// Numbers the distinct patches by their counts of links and lays them out in this order.
constexpr void pack(Derived& derived) {
  PatchTable& table = derived.table;
  uint8_t number[PatchTable::distinct] = {};
  uint8_t numbered = 0;
  int bytes = 0;
  for (int count = Patch::min_links; count <= Patch::max_links; ++count)
    for (int i = 0; i < derived.distinct; ++i) {
      const LinkRing& patch = derived.patch[i];
      if (patch.count != count) continue;
      number[i] = numbered++;
      ++table.of_count[count - Patch::min_links];
      table.patch[bytes++] =
          static_cast<uint8_t>(static_cast<int>(patch.kind) << 5 | patch.incidence);
      table.patch[bytes++] = patch.start;
      for (int l = 0; l < count; ++l) table.patch[bytes++] = patch.link[l];
    }
  for (uint8_t& index : table.index) index = number[index];
}

constexpr Derived derive_all() {
  Derived derived{};
  derived.one_patch_an_incidence = true;
  derived.one_fan_a_cell = true;
  for (int c = 0; c < configurations; ++c) {
    begin_configuration(derived, c);
    const Loops loops = derive::loops(static_cast<Configuration>(c));
    int fans = 0;
    for (int l = 0; l < loops.count; ++l) {
      add_loop(derived, loops.loop[l]);
      fans += !is_flat(loops.loop[l]);
    }
    if (fans > 1) derived.one_fan_a_cell = false;
  }
  begin_configuration(derived, configurations);
  pack(derived);
  for (int c = 0; c < configurations; ++c) measure_cell(derived, c);
  for (int lower = 0; lower < 16; ++lower) derived.table.below[lower] = below_links(derived, lower);
  return derived;
}

constexpr Derived derived = derive_all();

static_assert(derived.total == PatchTable::total, "patches of all configurations");
static_assert(derived.distinct == PatchTable::distinct, "222 different patches");
static_assert(derived.one_patch_an_incidence, "a cell has at most one patch an incidence");
static_assert(derived.one_fan_a_cell, "a cell has at most one fan");
static_assert(derived.bounds.patches == cell_bounds.patches, "at most five patches a cell");
static_assert(derived.bounds.links == cell_bounds.links, "links of a cell");
static_assert(derived.bounds.behind_links == cell_bounds.behind_links,
              "links towards visited cells");
static_assert(derived.bounds.ahead_links == cell_bounds.ahead_links, "links towards cells to come");

}  // namespace

const PatchTable patch_table = derived.table;

}  // namespace discmc
