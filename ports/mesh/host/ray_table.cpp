#include "ray_table.hpp"
#include <discmc/trace/sector_derivation.hpp>
#include "corner_code.hpp"
#include "edges.hpp"

namespace discmc::host {

namespace {

using detail::trace::AxisTable;
using detail::trace::CellAtVertex;
using detail::trace::quadrants;
using detail::trace::SectorTable;
using detail::trace::Way;

constexpr SectorTable sectors = detail::trace::derive::sector_table();

constexpr Vertex unit(int axis) {
  return {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
}

// Calls visit(axis, quadrant, way, is_spoke) for every way by which chains arrive, or leave.
template <class Visit>
constexpr void for_each_way(bool arrives, Visit visit) {
  for (int axis = 0; axis < 3; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant) {
      const Way* const ways = sectors.axis[axis].way[quadrant];
      for (int way = detail::trace::straight_way; way < detail::trace::ways; ++way)
        visit(axis, quadrant, ways[way], false);
      for (const auto& edge_pairs : sectors.edges)
        for (const uint8_t edge_pair : edge_pairs)
          if (edge_pair != 0)
            visit(axis, quadrant, ways[arrives ? edge_pair >> 4 : edge_pair & 15], true);
    }
}

constexpr QueueTraits derive_queue_traits() {
  QueueTraits traits{};
  bool are_begins[detail::trace::queue_count] = {};
  for_each_way(true, [&](int, int, Way way, bool) {
    if (way.is_ahead()) are_begins[way.queue_in()] = true;
  });
  uint32_t next[] = {0, first_begins};
  for (uint8_t queue = 0; queue < detail::trace::queue_count; ++queue) {
    const uint32_t code = next[are_begins[queue] ? 1 : 0]++;
    traits.code[queue] = static_cast<QueueCode>(code);
  }
  for_each_way(true, [&](int axis, int quadrant, Way way, bool is_spoke) {
    const uint32_t code = traits.code[way.queue_in()];
    traits.incoming[code] =
        opposite_link(is_spoke ? sectors.axis[axis].inwards[quadrant] : way.link());
    traits.vertex[code] =
        CornerCode::vector(unit(axis)) + CornerCode::links(traits.incoming[code], 0);
  });
  for_each_way(false, [&](int axis, int quadrant, Way way, bool is_spoke) {
    const uint32_t code = traits.code[way.queue_out()];
    traits.outgoing[code] = is_spoke ? sectors.axis[axis].inwards[quadrant] : way.link();
    traits.turns[code] = traits.outgoing[code] != way.link() ? 1 : 0;
    traits.centroid[code] = CornerCode::vector(unit(axis) + link_vector(traits.outgoing[code])) +
                            CornerCode::links(traits.outgoing[code], way.link());
  });
  traits.incoming[seam_begins] = traits.outgoing[seam_tails] = CornerCode::beyond_seam;
  traits.vertex[seam_begins] = CornerCode::links(CornerCode::beyond_seam, 0);
  for (uint32_t code = 0; code < queue_codes; ++code) {
    const bool has_begins = code >= first_begins;
    (has_begins ? traits.comes_from_ahead : traits.goes_ahead)[code] = UINT32_MAX;
    constexpr uint32_t no_link_in = 30, no_link_out = 31, begins_bit = 32;
    const uint32_t kind_bit = has_begins ? begins_bit : 0;
    const bool turns = traits.turns[code] != 0;
    traits.straight_in[code] =
        (turns && has_begins ? no_link_in : traits.incoming[code]) | kind_bit;
    traits.straight_out[code] = (turns ? no_link_out : traits.outgoing[code]) | kind_bit;
  }
  return traits;
}

constexpr QueueTraits derived_queue_traits = derive_queue_traits();

// ---- rays ----

constexpr RayWord ray_word(const Way& arrival, const Way& departure, Incidence behind) {
  return pass_word(derived_queue_traits.code[arrival.queue_in()],
                   derived_queue_traits.code[departure.queue_out()], behind);
}

constexpr uint32_t turned(uint32_t heading, uint32_t eighths) {
  return heading == detail::trace::no_heading ? heading : (heading + eighths) % 8;
}

// A half of a neighbourhood, for any axis, turned to the first half.
struct Half {
  uint32_t lower_is_on;
  uint32_t heading[4] = {};  // of its sectors
  uint32_t edges[2] = {};    // of the cells' spokes, or 0
  uint32_t face[2] = {};     // the ways on their first faces; 0 if the second face has no ray
  uint32_t parts = 0;        // an index of RayTable::parts

  constexpr Half(uint32_t lower, uint32_t lines) : lower_is_on(lower) {
    uint32_t part[2] = {};
    for (uint32_t i = 0; i < 2; ++i) {
      const CellAtVertex cell = sectors.cell_at(static_cast<int>(lower), lines >> 4 * i & 63);
      uint32_t* const headings = heading + size_t{2} * i;
      headings[0] = turned(cell.headings & 15, 2 * i);
      headings[1] = turned(cell.headings >> 4, 2 * i);
      edges[i] = cell.edges;
      face[i] = sectors.face_way_at(static_cast<int>(lower), lines >> 4 * i & 3);
      part[i] = cell.part;
    }
    if (heading[1] == heading[2]) face[1] = 0;
    // Numbers unordered pairs of parts without gaps.
    const uint32_t greater = part[0] > part[1] ? part[0] : part[1];
    parts = greater * (greater + 1) / 2 + (part[0] + part[1] - greater);
  }

  // Identifies the kind: equal keys mean equal rays for all axes. Never 0.
  constexpr uint64_t key() const {
    uint64_t bits = 2 | lower_is_on;
    for (const uint32_t h : heading) bits = bits << 4 | h;
    for (int i = 0; i < 2; ++i) bits = bits << 12 | edges[i] << 4 | face[i];
    return bits;
  }

  constexpr HalfRays rays(int axis, int half) const {
    const AxisTable& table = sectors.axis[axis];
    const auto incidence = [&](uint32_t sector) {
      return sectors.incidence_at(
          axis, static_cast<int>(lower_is_on),
          static_cast<int>(turned(heading[sector], 4 * static_cast<uint32_t>(half))));
    };
    HalfRays rays{};
    uint32_t count = 0;
    for (uint32_t i = 0; i < 2; ++i) {
      const Way* const ways = table.way[2 * half + static_cast<int>(i)];
      const Way& on_face = ways[face[i]];
      const RayWord first = ray_word(on_face, on_face, incidence(2 * i));
      if (i == 0)
        rays.first = first;
      else if (face[i] != 0)
        rays.ray[count++] = first;
      if (edges[i] != 0)
        rays.ray[count++] =
            ray_word(ways[edges[i] >> 4], ways[edges[i] & 15], incidence(2 * i + 1));
    }
    rays.first |= uint32_t{incidence(3)} << HalfRays::last_shift | count << HalfRays::count_shift;
    return rays;
  }
};

// ---- the table ----

// Returns the bits of RayTable::lines for a voxel, by its position relative to the middle voxel.
constexpr uint64_t bits_of_voxel(int x, int y, int z) {
  uint64_t bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int at[] = {x, y, z};
    const int along = at[axis], u = at[(axis + 1) % 3], v = at[(axis + 2) % 3];
    uint64_t line_bits = along == 0 && u == 0 && v == 0 ? 1U << HalfRays::lines_bits : 0;
    for (int index = 0; along >= 0 && index < 10; ++index) {
      const Vertex line = detail::trace::derive::line_at((index < 5 ? index : index - 1) % 8);
      const int shift = 2 * index + (index < 5 ? 0 : 1) + along;
      if (line.y == u && line.z == v) line_bits |= uint64_t{1} << shift;
    }
    bits |= line_bits << RayTable::axis_bits * static_cast<uint32_t>(axis);
  }
  return bits;
}

constexpr RayTable derive_rays() {
  RayTable table{};
  for (int z = 0; z < 3; ++z)
    for (uint32_t voxel = 0; voxel < 9; ++voxel) {
      const uint64_t bits =
          bits_of_voxel(static_cast<int>(voxel % 3) - 1, static_cast<int>(voxel / 3) - 1, z - 1);
      for (uint32_t lower = 0; lower < 1U << voxel; ++lower)
        table.lines[z][1U << voxel | lower] = table.lines[z][lower] | bits;
    }
  for (uint32_t greater = 0; greater < 15; ++greater)
    for (uint32_t other = 0; other <= greater; ++other)
      table.parts[greater * (greater + 1) / 2 + other] =
          PartSum::from_part(sectors.part[greater]) + PartSum::from_part(sectors.part[other]);

  constexpr uint32_t buckets = 1024;
  uint64_t keys[buckets] = {};
  uint16_t number[buckets] = {};
  uint16_t kinds = 0;
  for (uint32_t lower = 0; lower < 2; ++lower)
    for (uint32_t lines = 0; lines < 1U << HalfRays::lines_bits; ++lines) {
      const Half half(lower, lines);
      const uint64_t key = half.key();
      auto bucket = static_cast<uint32_t>(key % 1021);
      while (keys[bucket] != 0 && keys[bucket] != key) bucket = (bucket + 1) % buckets;
      if (keys[bucket] == 0) {
        keys[bucket] = key;
        number[bucket] = kinds;
        for (int axis = 0; axis < 3; ++axis)
          for (int i = 0; i < 2; ++i) table.rays[axis][i][kinds] = half.rays(axis, i);
        ++kinds;
      }
      const RayTable::Kind kind{number[bucket], static_cast<uint16_t>(half.parts)};
      table.kind[0][lines | lower << HalfRays::lines_bits] = kind;
      table.kind[1][lines << 1 | lower] = kind;
    }
  return table;
}

constexpr RayTable derived_rays = derive_rays();
static_assert(derived_rays.rays[0][0][HalfRays::kinds - 1].first != 0,
              "kinds is the number of kinds");

constexpr bool sums_have_room() {
  constexpr uint64_t field = (uint64_t{1} << PartSum::bits) - 1;
  for (uint64_t parts : derived_rays.parts)
    for (; parts != 0; parts >>= PartSum::bits)
      if ((parts & field) * 2 * Edges::max_edges > field) return false;
  return true;
}
static_assert(sums_have_room(), "the parts of all edges of a batch, two halves each, fit");

}  // namespace

const RayTable ray_table = derived_rays;
const QueueTraits queue_traits = derived_queue_traits;

}  // namespace discmc::host
