// Derives the table of sectors from the face rule of cell.hpp, at compile time only.
#ifndef DISCMC_TRACE_SECTOR_DERIVATION_HPP
#define DISCMC_TRACE_SECTOR_DERIVATION_HPP

#include <discmc/geometry/loop_facets.hpp>
#include <discmc/trace/sector_table.hpp>

namespace discmc::detail::trace::derive {

// Converts a vector from the frame of an edge's axis and the two axes after it to the volume's
// frame.
constexpr Vertex from_axis_frame(int axis, const Vertex& v) {
  return axis == 0 ? v : axis == 1 ? Vertex{v.z, v.x, v.y} : Vertex{v.y, v.z, v.x};
}

constexpr Vertex quarter_turns(Vertex v, int count) {
  for (; count > 0; --count) v = {v.x, -v.z, v.y};
  return v;
}

// ---- the order of visits ----

// A vertex is visited with the voxel below it on its axis. Voxels come in the order z, y, x, and
// the edges of each in the order x, y, z.
constexpr bool is_visited_before(const Vertex& a, const Vertex& b) {
  const int by_voxel[] = {(a.z >> 1) - (b.z >> 1), (a.y >> 1) - (b.y >> 1), (a.x >> 1) - (b.x >> 1),
                          ((a.y & 1) + 2 * (a.z & 1)) - ((b.y & 1) + 2 * (b.z & 1))};
  for (const int difference : by_voxel)
    if (difference != 0) return difference < 0;
  return false;
}

constexpr bool is_in_next_slice(const Vertex& a, const Vertex& b) {
  return a.z >> 1 != b.z >> 1;
}

// ---- edges of a cell ----

struct EdgeNumbers {
  CellPoint point[cell_edges];
  CellEdge number[point_codes];
};

constexpr EdgeNumbers number_edges() {
  EdgeNumbers edges{};
  int count = 0;
  for (CellPoint point = 0; point < point_codes; ++point) {
    const Vertex at = position(point);
    if (at.x > 2 || at.y > 2) continue;
    if ((at.x == 1) + (at.y == 1) + (at.z == 1) != 1) continue;
    int index = count++;
    for (; index > 0 && is_visited_before(at, position(edges.point[index - 1])); --index)
      edges.point[index] = edges.point[index - 1];
    edges.point[index] = point;
  }
  for (int i = 0; i < cell_edges; ++i) edges.number[edges.point[i]] = static_cast<CellEdge>(i);
  return edges;
}

constexpr EdgeNumbers edges = number_edges();

// Returns the cell's edge in a quadrant that corresponds to an edge of quadrant 0 by rotation.
constexpr CellEdge turned_edge(CellEdge edge, int quadrant) {
  Vertex at = quarter_turns(position(edges.point[edge]), quadrant);
  if (quadrant == 1 || quadrant == 2) at.y += 2;
  if (quadrant >= 2) at.z += 2;
  return edges.number[point_at(at)];
}

// ---- the loop through a vertex ----

// Returns the configuration of the cell in quadrant 0 of an edge along x.
constexpr Configuration configuration_of(int lower_is_on, int lines) {
  return static_cast<Configuration>((lower_is_on != 0 ? 1 : 2) | (lines & 3) << 2 |
                                    (lines >> 2 & 3) << 6 | (lines >> 4) << 4);
}

struct VertexLoop {
  LoopFacets facets;
  int index;   // index of the vertex in the loop
  int points;  // number of points in all loops of the cell
};

constexpr VertexLoop loop_at_vertex(Configuration configuration) {
  const CellPoint vertex = point_at({1, 0, 0});
  const Loops loops = discmc::detail::derive::loops(configuration);
  VertexLoop result{};
  for (int l = 0; l < loops.count; ++l) {
    result.points += loops.loop[l].count;
    for (int i = 0; i < loops.loop[l].count; ++i) {
      if (loops.loop[l].point[i] != vertex) continue;
      result.facets = facets_of(loops.loop[l]);
      result.index = i;
    }
  }
  return result;
}

// Returns the position of a heading's line, seen along the axis.
constexpr Vertex line_at(int heading) {
  return quarter_turns(heading % 2 == 0 ? Vertex{0, 1, 0} : Vertex{0, 1, 1}, heading / 2);
}

constexpr uint8_t heading_of(Incidence incidence) {
  const Vertex n = incidence_normal(incidence);
  for (uint8_t heading = 0; heading < no_heading; ++heading)
    if (line_at(heading).y == n.y && line_at(heading).z == n.z) return heading;
  return no_heading;
}

constexpr CellAtVertex cell_at_vertex(int lower_is_on, int lines) {
  const VertexLoop vertex = loop_at_vertex(configuration_of(lower_is_on, lines));
  const LoopFacets& facets = vertex.facets;
  const int i = vertex.index;
  const Incidence before = facets.behind(i - 1);
  const Incidence after = facets.behind(i);
  const Incidence first = lower_is_on != 0 ? after : before;
  const Incidence second = lower_is_on != 0 ? before : after;
  const auto headings = static_cast<uint8_t>(heading_of(first) | heading_of(second) << 4);
  if (before == after) return {headings, 0, 0};
  // Facets before the vertex end at its spoke. Their chain leaves the vertex for their beginning.
  int begin = i - 1;
  while (facets.behind(begin - 1) == before) --begin;
  // Facets after it begin there. Their chain comes from their end.
  int end = i + 1;
  while (facets.behind(end) == after) ++end;
  const CellEdge to = edges.number[facets.loop.point[facets.wrap(begin)]];
  const CellEdge from = edges.number[facets.loop.point[facets.wrap(end)]];
  return {headings, static_cast<uint8_t>(to | from << 4), 0};
}

// ---- ways: links along rays ----

// Converts an edge from the frame of axis x and quadrant 0 to its own axis and quadrant.
constexpr CellEdge edge_in(int axis, int quadrant, CellEdge edge) {
  const CellEdge turned = turned_edge(edge, quadrant);
  return edges.number[point_at(from_axis_frame(axis, position(edges.point[turned])))];
}

// Returns the edge of the quadrant's cell on which the vertex lies.
constexpr CellEdge own_edge(int axis, int quadrant) {
  return edge_in(axis, quadrant, edges.number[point_at({1, 0, 0})]);
}

constexpr Link link_inwards(CellEdge edge) {
  return discmc::detail::derive::link_of(detail::link_table,
                                         position(centroid) - position(edges.point[edge]));
}

// Numbers queues, those within a slice first.
struct QueueNumbers {
  int level = 0;
  int rising = first_rising_queue;
  constexpr uint8_t add(int count, bool is_rising) {
    int& next = is_rising ? rising : level;
    next += count;
    return static_cast<uint8_t>(next - count);
  }
};

// The queue for chains from an edge of a cell by the centroid to another. The reverse path has the
// other queue of a pair, even if no chain uses it.
struct SpokeQueues {
  uint8_t queue[cell_edges][cell_edges];
};

constexpr SpokeQueues number_spoke_queues(const SectorTable& table, QueueNumbers& numbers) {
  bool is_used[cell_edges][cell_edges] = {};
  for (int axis = 0; axis < 3; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      for (const auto& edge_pairs : table.edges)
        for (const uint8_t edge_pair : edge_pairs)
          if (edge_pair != 0) {
            const CellEdge own = own_edge(axis, quadrant);
            is_used[own][edge_in(axis, quadrant, edge_pair & 15)] = true;
            is_used[edge_in(axis, quadrant, edge_pair >> 4)][own] = true;
          }
  SpokeQueues spokes{};
  const auto add = [&](int from, int to, int count) {
    const bool is_rising = is_in_next_slice(position(edges.point[from]), position(edges.point[to]));
    spokes.queue[from][to] = numbers.add(count, is_rising);
    spokes.queue[to][from] = spokes.queue[from][to] ^ 1;
  };
  for (int from = 0; from < cell_edges; ++from)
    for (int to = from + 1; to < cell_edges; ++to)
      if (is_used[from][to] && is_used[to][from]) add(from, to, 2);
  for (int from = 0; from < cell_edges; ++from)
    for (int to = 0; to < cell_edges; ++to)
      if (is_used[from][to] && !is_used[to][from]) add(from, to, 1);
  return spokes;
}

constexpr void add_spoke_ways(SectorTable& table, const SpokeQueues& spokes) {
  for (int axis = 0; axis < 3; ++axis)
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      for (const auto& edge_pairs : table.edges)
        for (const uint8_t edge_pair : edge_pairs) {
          if (edge_pair == 0) continue;
          const CellEdge own = own_edge(axis, quadrant);
          const uint8_t ways_of_pair[] = {static_cast<uint8_t>(edge_pair & 15),
                                          static_cast<uint8_t>(edge_pair >> 4)};
          for (const uint8_t way : ways_of_pair) {
            const CellEdge other = edge_in(axis, quadrant, way);
            table.axis[axis].way[quadrant][way] =
                Way(opposite_link(link_inwards(other)), spokes.queue[own][other], other > own);
          }
        }
}

constexpr Vertex face_vector(int quadrant, uint8_t way) {
  const Vertex across = quarter_turns({0, 1, 0}, quadrant);
  return way == straight_way ? across + across
                             : across + Vertex{way == downward_way ? -1 : 1, 0, 0};
}

constexpr Vertex lowest_on_axis(int axis) {
  return from_axis_frame(axis, {1, 0, 0});
}

// The same link begins at both of its vertices: the earlier one names it.
constexpr uint8_t queue_of_face_link(const SectorTable& table, const Vertex& begin, Link link) {
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& ways_of_quadrant : table.axis[axis].way)
      for (int i = straight_way; i < ways; ++i) {
        const Way& way = ways_of_quadrant[i];
        if (lowest_on_axis(axis) == begin && way.link() == link) return way.queue_out();
      }
  return queue_count;
}

// Moves a vertex by whole cells to the beginning of edges of the cell at the origin.
constexpr Vertex moved_to_origin(const Vertex& v) {
  return {v.x & 1, v.y & 1, v.z & 1};
}

constexpr void add_face_ways(SectorTable& table, QueueNumbers& numbers) {
  // The first pass numbers the queues of links ahead; the second pass finds them for links behind.
  for (int pass = 0; pass < 2; ++pass)
    for (int axis = 0; axis < 3; ++axis)
      for (int quadrant = 0; quadrant < quadrants; ++quadrant)
        for (uint8_t way = straight_way; way < ways; ++way) {
          const Vertex here = lowest_on_axis(axis);
          const Vertex vector = from_axis_frame(axis, face_vector(quadrant, way));
          const Vertex other = here + vector;
          const bool is_ahead = is_visited_before(here, other);
          if (is_ahead != (pass == 0)) continue;
          const Link link = discmc::detail::derive::link_of(detail::link_table, vector);
          const auto queue = static_cast<uint8_t>(
              is_ahead
                  ? numbers.add(2, is_in_next_slice(here, other))
                  : queue_of_face_link(table, moved_to_origin(other), opposite_link(link)) + 1);
          table.axis[axis].way[quadrant][way] = Way(link, queue, is_ahead);
        }
}

// Returns the direction of a face's link from a vertex, by the bits of the other line on that face.
// On corners are separated.
constexpr uint8_t face_way_of(int lower_is_on, int line) {
  const bool is_lower_on = (line & 1) != 0, is_upper_on = (line & 2) != 0;
  const bool is_here_on = lower_is_on != 0;
  if (is_lower_on != is_upper_on && is_lower_on == is_here_on) return straight_way;
  // The link cuts off one corner of the middle line, the corner that is on. If both other corners
  // are on, the link cuts off the corner that is off.
  const bool is_upper_cut_off = is_lower_on && is_upper_on ? is_here_on : !is_here_on;
  return is_upper_cut_off ? upward_way : downward_way;
}

// ---- counts ----

constexpr uint32_t part_of(int lines) {
  const VertexLoop vertex = loop_at_vertex(configuration_of(0, lines));
  const uint32_t points = vertex.facets.loop.count;
  const uint32_t cell = CountParts::cell / static_cast<uint32_t>(vertex.points);
  const uint32_t facet = vertex.facets.is_fan ? CountParts::facet : CountParts::facet / points;
  const uint32_t triangle = CountParts::triangle * (points - 2) / points;
  return cell | facet << CountParts::facet_shift | triangle << CountParts::triangle_shift;
}

// Returns the index of a value among `count` known values. A new value is appended first.
template <class Value>
constexpr int number_in(Value* known, int& count, Value value) {
  int number = 0;
  while (number < count && known[number] != value) ++number;
  known[number] = value;
  if (number == count) ++count;
  return number;
}

// ---- the table ----

constexpr void add_cells(SectorTable& table) {
  int parts = 0, edges_known = 0;
  for (uint32_t lines = 0; lines < 64; ++lines) {
    const CellAtVertex cell = cell_at_vertex(0, static_cast<int>(lines));
    const int index = number_in(table.edges[0], edges_known, cell.edges);
    table.edges[1][index] = cell_at_vertex(1, static_cast<int>(mirrored(lines))).edges;
    const int part = number_in(table.part, parts, part_of(static_cast<int>(lines)));
    table.cell[lines] = static_cast<uint16_t>(cell.headings | index << 8 | part << 12);
  }
}

constexpr void add_incidences(AxisTable& table, int axis) {
  for (uint8_t heading = 0; heading <= no_heading; ++heading) {
    Vertex n = heading == no_heading ? Vertex{0, 0, 0} : line_at(heading);
    n.x = -1;
    table.incidence[heading] = incidence_of(from_axis_frame(axis, n));
  }
  table.to_upper = static_cast<uint8_t>(incidence_of(from_axis_frame(axis, {1, 0, 0})) -
                                        incidence_of(from_axis_frame(axis, {-1, 0, 0})));
}

constexpr SectorTable sector_table() {
  SectorTable table{};
  add_cells(table);
  for (int lower = 0; lower < 2; ++lower)
    for (uint32_t line = 0; line < 4; ++line)
      table.face_way[lower][lower != 0 ? mirrored(line) : line] =
          face_way_of(lower, static_cast<int>(line));
  for (int axis = 0; axis < 3; ++axis) {
    add_incidences(table.axis[axis], axis);
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      table.axis[axis].inwards[quadrant] = link_inwards(own_edge(axis, quadrant));
  }
  QueueNumbers numbers;
  add_face_ways(table, numbers);
  add_spoke_ways(table, number_spoke_queues(table, numbers));
  return table;
}

}  // namespace discmc::detail::trace::derive

#endif
