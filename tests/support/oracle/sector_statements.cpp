#include "sector_statements.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <discmc/geometry/facet_table.hpp>
#include <iterator>
#include <utility>
#include <vector>

namespace discmc::reference {

namespace {

using detail::trace::cell_edges;
using detail::trace::CellAtVertex;
using detail::trace::CellEdge;
using detail::trace::CountParts;
using detail::trace::quadrants;
using detail::trace::SectorTable;
using detail::trace::Way;

constexpr int axes = 3;

// Returns a vector by its components along an axis and the two axes after it.
Vertex along(int axis, int a, int u, int v) {
  int part[3] = {};
  part[axis] = a;
  part[(axis + 1) % 3] = u;
  part[(axis + 2) % 3] = v;
  return {part[0], part[1], part[2]};
}

// The position of a line of the ring, relative to the middle line. Units: voxels.
struct LineOffset {
  int u, v;
};
constexpr LineOffset ring[] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                               {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

// ---- the order of visits ----

// Orders vertices by the voxel at the lower end of the edge, in z, y, x; then by axis.
std::array<int, 4> visit(const Vertex& vertex) {
  const auto voxel = [](int coordinate) { return (coordinate - (coordinate & 1)) / 2; };
  return {voxel(vertex.z), voxel(vertex.y), voxel(vertex.x), (vertex.y & 1) + 2 * (vertex.z & 1)};
}
bool rises(const Vertex& a, const Vertex& b) {
  return visit(a)[0] != visit(b)[0];
}

// Returns the midpoints of a cell's edges in the order in which a sweep visits them.
const std::array<Vertex, cell_edges>& edges() {
  static const std::array<Vertex, cell_edges> all = [] {
    std::array<Vertex, cell_edges> sorted{};
    size_t count = 0;
    for (int axis = 0; axis < axes; ++axis)
      for (const int u : {0, 2})
        for (const int v : {0, 2}) sorted.at(count++) = along(axis, 1, u, v);
    std::sort(sorted.begin(), sorted.end(),
              [](const Vertex& a, const Vertex& b) { return visit(a) < visit(b); });
    return sorted;
  }();
  return all;
}
CellEdge edge_at(const Vertex& midpoint) {
  return static_cast<CellEdge>(std::find(edges().begin(), edges().end(), midpoint) -
                               edges().begin());
}

// ---- the surface in a cell, seen from one of its vertices ----

// The cell in a quadrant of an edge along an axis.
struct Quadrant {
  int axis, number;

  const LineOffset& line(int i) const { return ring[(2 * number + i) % 8]; }
  int min_u() const { return std::min({0, line(0).u, line(1).u, line(2).u}); }
  int min_v() const { return std::min({0, line(0).v, line(1).v, line(2).v}); }
  Vertex vertex() const { return along(axis, 1, -2 * min_u(), -2 * min_v()); }

  Configuration configuration(int lower_is_on, int lines) const {
    unsigned bits = 0;
    const auto add = [&](const LineOffset& place, int on) {
      for (int end = 0; end < 2; ++end) {
        const Vertex corner = along(axis, end, place.u - min_u(), place.v - min_v());
        if ((on >> end & 1) != 0) bits |= 1U << (corner.x + 2 * corner.y + 4 * corner.z);
      }
    };
    add({0, 0}, lower_is_on != 0 ? 1 : 2);
    for (int i = 0; i < 3; ++i) add(line(i), lines >> 2 * i & 3);
    return static_cast<Configuration>(bits);
  }

  // Whether a point lies on the face between the vertex and a line.
  bool is_on_face(const Vertex& point, int i) const {
    return dot_product(along(axis, 0, line(i).v, line(i).u), point - vertex()) == 0;
  }
};

struct FaceLook {
  Incidence incidence;  // of the facet at the face
  Vertex link;          // from the vertex, on the face
};
struct Look {
  FaceLook face[2];  // at the quadrant's first line and at its last
  CellEdge to;       // reached by a chain that leaves by the centroid; cell_edges: none
  CellEdge from;     // origin of a chain that arrives by the centroid
};

using PointLink = std::pair<Vertex, Vertex>;

// Returns the links around the facets of one incidence, without links whose opposite is present.
std::vector<PointLink> boundary(Configuration configuration, Incidence incidence) {
  std::vector<PointLink> links;
  for (int i = facet_table.first[configuration]; i < facet_table.first[configuration + 1]; ++i) {
    const Facet facet = facet_table.facet[i];
    if (incidence_of(facet) != incidence) continue;
    const FacetRing& points = facet_rings.ring[facet];
    for (int p = 0; p < points.count; ++p) {
      const Vertex from = position(points.point[p]);
      const Vertex to = position(points.point[(p + 1) % points.count]);
      const auto opposite = std::find(links.begin(), links.end(), PointLink{to, from});
      if (opposite == links.end())
        links.emplace_back(from, to);
      else
        links.erase(opposite);
    }
  }
  return links;
}

Look look(const Quadrant& quadrant, Configuration configuration) {
  Look seen{{}, cell_edges, cell_edges};
  const Vertex here = quadrant.vertex();
  const Vertex middle = position(centroid);
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (const auto& [from, to] : boundary(configuration, incidence)) {
      const Vertex other = from == here ? to : from;
      for (int face = 0; face < 2; ++face)
        if ((from == here || to == here) && quadrant.is_on_face(other, 2 * face))
          seen.face[face] = {incidence, other - here};
      for (const auto& [next, last] : boundary(configuration, incidence)) {
        if (to != middle || next != middle) continue;
        if (from == here) seen.to = edge_at(last);
        if (last == here) seen.from = edge_at(from);
      }
    }
  return seen;
}

using Looks = std::array<std::array<Look, 64>, 2>;  // [lower end is on][lines]

const Looks& looks_of(int axis, int quadrant) {
  static const std::vector<Looks> all = [] {
    std::vector<Looks> looks(axes * quadrants);
    for (int i = 0; i < axes * quadrants; ++i)
      for (int lower = 0; lower < 2; ++lower)
        for (int lines = 0; lines < 64; ++lines) {
          const Quadrant at{i / quadrants, i % quadrants};
          looks[static_cast<size_t>(i)][static_cast<size_t>(lower)][static_cast<size_t>(lines)] =
              look(at, at.configuration(lower, lines));
        }
    return looks;
  }();
  return all[static_cast<size_t>(axis * quadrants + quadrant)];
}

// ---- statements ----

// Converts an edge named by CellAtVertex, which uses axis x and quadrant 0, to an edge of a
// quadrant's cell.
CellEdge edge_in(const Quadrant& quadrant, CellEdge named) {
  const Vertex at = edges().at(named);
  const LineOffset& u = quadrant.line(0);  // image of the first axis after x
  const LineOffset& v = quadrant.line(2);  // image of the second axis
  const int at_u = at.y * u.u + at.z * v.u, at_v = at.y * u.v + at.z * v.v;
  return edge_at(
      along(quadrant.axis, at.x, at_u - 2 * quadrant.min_u(), at_v - 2 * quadrant.min_v()));
}

// [from][to]: whether chains run from one edge of a cell by its centroid to another.
using Ways = std::array<std::array<bool, cell_edges>, cell_edges>;

const Ways& ways_by_centroids() {
  static const Ways result = [] {
    Ways ways{};
    for (int axis = 0; axis < axes; ++axis)
      for (int quadrant = 0; quadrant < quadrants; ++quadrant)
        for (const auto& looks : looks_of(axis, quadrant))
          for (const Look& seen : looks) {
            if (seen.to == cell_edges) continue;
            const CellEdge own = edge_at(Quadrant{axis, quadrant}.vertex());
            ways.at(own).at(seen.to) = ways.at(seen.from).at(own) = true;
          }
    return ways;
  }();
  return result;
}

bool leads_to_centroids(const SectorTable& table) {
  for (int axis = 0; axis < axes; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant) {
      const Link inwards = table.axis[axis].inwards[quadrant];
      const Vertex here = Quadrant{axis, quadrant}.vertex();
      if (inwards >= link_codes || here + link_vector(inwards) != position(centroid)) return false;
    }
  return true;
}

bool points_where_headings_lie(const SectorTable& table) {
  for (int axis = 0; axis < axes; ++axis)
    for (int lower = 0; lower < 2; ++lower)
      for (int heading = 0; heading <= detail::trace::no_heading; ++heading) {
        const LineOffset place =
            heading == detail::trace::no_heading ? LineOffset{0, 0} : ring[heading];
        const Vertex n = along(axis, lower != 0 ? 1 : -1, place.u, place.v);
        if (table.incidence_at(axis, lower, heading) != incidence_of(n)) return false;
      }
  return true;
}

// Returns the vector of a ray along its way.
Vertex ray_vector(int axis, int quadrant, int way) {
  const LineOffset across = ring[2 * quadrant];
  return way == detail::trace::straight_way
             ? along(axis, 0, 2 * across.u, 2 * across.v)
             : along(axis, way == detail::trace::downward_way ? -1 : 1, across.u, across.v);
}

// A way has no bits other than those of its members.
bool is_way(const Way& way, const Vertex& vector, bool is_ahead) {
  if (way.link() >= link_codes || link_vector(way.link()) != vector) return false;
  const Way rebuilt(way.link(), way.queue_out(), is_ahead);
  return std::memcmp(&rebuilt, &way, sizeof way) == 0;
}

bool leads_across_faces(const SectorTable& table) {
  for (int axis = 0; axis < axes; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      for (int way = detail::trace::straight_way; way < detail::trace::ways; ++way) {
        const Vertex here = along(axis, 1, 0, 0);
        const Vertex vector = ray_vector(axis, quadrant, way);
        if (!is_way(table.axis[axis].way[quadrant][way], vector,
                    visit(here) < visit(here + vector)))
          return false;
      }
  return true;
}

// Chains use some of the ways by a centroid, in one direction or both; the others are empty.
bool leads_by_centroids(const SectorTable& table) {
  for (int axis = 0; axis < axes; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      for (CellEdge named = 0; named < cell_edges; ++named) {
        const Way& way = table.axis[axis].way[quadrant][named];
        const CellEdge own = edge_at(Quadrant{axis, quadrant}.vertex());
        const CellEdge other = edge_in({axis, quadrant}, named);
        const bool is_used =
            ways_by_centroids().at(own).at(other) || ways_by_centroids().at(other).at(own);
        const Way empty;
        if (is_used ? !is_way(way, edges().at(other) - position(centroid), other > own)
                    : std::memcmp(&empty, &way, sizeof way) != 0)
          return false;
      }
  return true;
}

bool is_ray(const SectorTable& table, const FaceLook& seen, int axis, int lower, int quadrant,
            int line) {
  const uint8_t way = table.face_way_at(lower, static_cast<uint32_t>(line));
  if (way < detail::trace::straight_way || way >= detail::trace::ways) return false;
  return link_vector(table.axis[axis].way[quadrant][way].link()) == seen.link;
}

// Limit: the headings, edges and ways are correct.
bool is_seen(const SectorTable& table, int axis, int quadrant, int lower, int lines) {
  const CellAtVertex cell = table.cell_at(lower, static_cast<uint32_t>(lines));
  const Look& seen =
      looks_of(axis, quadrant)[static_cast<size_t>(lower)][static_cast<size_t>(lines)];
  // Turns headings from quadrant 0.
  const auto turned = [quadrant](int heading) {
    return heading == detail::trace::no_heading ? heading : (heading + 2 * quadrant) % 8;
  };
  const int first = cell.headings & 15, second = cell.headings >> 4;
  if (first > detail::trace::no_heading || second > detail::trace::no_heading) return false;
  if (table.incidence_at(axis, lower, turned(first)) != seen.face[0].incidence ||
      table.incidence_at(axis, lower, turned(second)) != seen.face[1].incidence)
    return false;
  if (!is_ray(table, seen.face[0], axis, lower, quadrant, lines & 3) ||
      !is_ray(table, seen.face[1], axis, lower, (quadrant + 1) % quadrants, lines >> 4))
    return false;
  if (seen.to == cell_edges) return first == second && cell.edges == 0;
  const int to = cell.edges & 15, from = cell.edges >> 4;
  return first != second && to < cell_edges && from < cell_edges &&
         edge_in({axis, quadrant}, static_cast<CellEdge>(to)) == seen.to &&
         edge_in({axis, quadrant}, static_cast<CellEdge>(from)) == seen.from;
}

bool sees_the_facets(const SectorTable& table) {
  for (int axis = 0; axis < axes; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      for (int lower = 0; lower < 2; ++lower)
        for (int lines = 0; lines < 64; ++lines)
          if (!is_seen(table, axis, quadrant, lower, lines)) return false;
  return true;
}

// ---- queues ----

// A kind of link and the queue of its chains. The kind is the earlier vertex with two vectors: to
// the later vertex, and to the centroid in between (zero on a face).
struct Kind {
  Vertex begin, vector, through;
  bool is_used[2];  // by chains forwards, and backwards
  int queue;
};

// Adds a way to the kinds, seen from a vertex. Returns false if its queue differs from that at the
// other end of the link. through: the centroid, or the vertex itself.
bool add_kind(std::vector<Kind>& kinds, const Way& way, const Vertex& here, const Vertex& other,
              const Vertex& through, bool leaves, bool arrives) {
  const bool is_ahead = visit(here) < visit(other);
  const Vertex& earlier = is_ahead ? here : other;
  const Kind kind{{earlier.x & 1, earlier.y & 1, earlier.z & 1},
                  is_ahead ? other - here : here - other,
                  through == here ? Vertex{0, 0, 0} : through - earlier,
                  {is_ahead ? leaves : arrives, is_ahead ? arrives : leaves},
                  is_ahead ? way.queue_out() : way.queue_in()};
  for (const Kind& known : kinds)
    if (known.begin == kind.begin && known.vector == kind.vector && known.through == kind.through)
      return known.queue == kind.queue;
  kinds.push_back(kind);
  return true;
}

bool agrees_from_both_ends(const SectorTable& table, std::vector<Kind>& kinds) {
  for (int axis = 0; axis < axes; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant) {
      const auto& ways = table.axis[axis].way[quadrant];
      const Vertex here = along(axis, 1, 0, 0);
      for (int way = detail::trace::straight_way; way < detail::trace::ways; ++way)
        if (!add_kind(kinds, ways[way], here, here + ray_vector(axis, quadrant, way), here, true,
                      true))
          return false;
      const CellEdge own = edge_at(Quadrant{axis, quadrant}.vertex());
      for (CellEdge named = 0; named < cell_edges; ++named) {
        const CellEdge other = edge_in({axis, quadrant}, named);
        const bool leaves = ways_by_centroids().at(own).at(other);
        const bool arrives = ways_by_centroids().at(other).at(own);
        if ((leaves || arrives) && !add_kind(kinds, ways[named], edges().at(own), edges().at(other),
                                             position(centroid), leaves, arrives))
          return false;
      }
    }
  return true;
}

// Each queue occurs once, and queues that rise to the next slice come last.
bool shares_no_queue(const std::vector<Kind>& kinds) {
  std::array<int, detail::trace::queue_count> users{};
  for (const Kind& kind : kinds)
    for (int way = 0; way < 2; ++way) {
      if (!kind.is_used[way]) continue;
      const int queue = way == 0 ? kind.queue : kind.queue ^ 1;
      if (queue >= detail::trace::queue_count) return false;
      if (rises(kind.begin, kind.begin + kind.vector) !=
          (queue >= detail::trace::first_rising_queue))
        return false;
      ++users.at(static_cast<size_t>(queue));
    }
  return std::all_of(users.begin(), users.end(), [](int count) { return count == 1; });
}

// ---- counts ----

struct Parts {
  uint32_t cell, facet, triangle;
};

// The index of a vertex' parts: [lower end is on][lines].
struct PartPlace {
  int lower, lines;
};

const std::vector<PartPlace>& places_of(int configuration) {
  static const std::vector<std::vector<PartPlace>> all = [] {
    std::vector<std::vector<PartPlace>> places(configurations);
    for (int axis = 0; axis < axes; ++axis)
      for (int quadrant = 0; quadrant < quadrants; ++quadrant)
        for (int lower = 0; lower < 2; ++lower)
          for (int lines = 0; lines < 64; ++lines)
            places[Quadrant{axis, quadrant}.configuration(lower, lines)].push_back({lower, lines});
    return places;
  }();
  return all[static_cast<size_t>(configuration)];
}

// Whether four parts fit into a word.
bool has_room(const Parts& parts) {
  constexpr uint32_t facet = CountParts::facet_shift, triangle = CountParts::triangle_shift;
  return 4 * parts.cell < 1U << facet && 4 * parts.facet < 1U << (triangle - facet) &&
         4 * parts.triangle < 1U << (32 - triangle);
}

bool adds_up(const SectorTable& table, int configuration) {
  Parts sum{};
  for (const PartPlace& place : places_of(configuration)) {
    const uint32_t word =
        table.part[table.cell_at(place.lower, static_cast<uint32_t>(place.lines)).part];
    constexpr uint32_t facet = CountParts::facet_shift, triangle = CountParts::triangle_shift;
    const Parts parts{word & ((1U << facet) - 1), word >> facet & ((1U << (triangle - facet)) - 1),
                      word >> triangle};
    if (!has_room(parts)) return false;
    sum = {sum.cell + parts.cell, sum.facet + parts.facet, sum.triangle + parts.triangle};
  }
  const bool is_active = configuration != 0 && configuration != configurations - 1;
  return sum.cell == (is_active ? CountParts::cell : 0) &&
         sum.facet == CountParts::facet * cell_facts.facets[configuration] &&
         sum.triangle == CountParts::triangle * cell_facts.classic_triangles[configuration];
}

}  // namespace

const char* broken(const SectorTable& table) {
  for (const uint32_t cell : table.cell)
    if ((cell >> 8 & 15) >= std::size(table.edges[0]) || cell >> 12 >= std::size(table.part))
      return "a cell has some of the edges, and one of the parts";
  if (!leads_to_centroids(table)) return "a spoke leads from the vertex to the centroid";
  if (!points_where_headings_lie(table)) return "a heading is an incidence of each axis";
  if (!leads_across_faces(table)) return "a way on a face has its link, ahead or behind";
  if (!leads_by_centroids(table)) return "a way by a centroid leads to another edge of the cell";
  if (!sees_the_facets(table)) return "a vertex sees the facets of its four cells";
  std::vector<Kind> kinds;
  if (!agrees_from_both_ends(table, kinds)) return "both ends of a link know one queue";
  if (!shares_no_queue(kinds)) return "no two kinds of links share a queue";
  for (int c = 0; c < configurations; ++c)
    if (!adds_up(table, c)) return "the parts of a cell's vertices add up to what it counts";
  return nullptr;
}

}  // namespace discmc::reference
