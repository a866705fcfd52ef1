// What the functions of merge.hpp do, but for those of delivery_definitions.hpp: included where
// Merge is instantiated.
#ifndef DISCMC_MERGE_DEFINITIONS_HPP
#define DISCMC_MERGE_DEFINITIONS_HPP

#include <discmc/merge.hpp>

namespace discmc {

// Where link i of a walk's patch begins.
template <class Walk>
Vertex start_of_link(const Walk& walk, int i, uint32_t halo) {
  const Patch& patch = walk.patch;
  Point point = patch.start;
  for (int l = 0; l < i; ++l)
    point = point_after(point, link_of(patch.incidence, patch.direction(l)));
  const Cell& cell = walk.cell;
  const Vertex origin{2 * static_cast<int32_t>(cell.column - halo),
                      2 * static_cast<int32_t>(cell.row - halo), cell.z};
  return origin + position(point);
}

// A patch's ring under construction. It is closed at all times: `current`, whose fragment grows, is
// followed by `first`. When link 0 is not left open, `first` is a marker, an edge without a link
// that finish_walk() takes out again.
template <class Index, class Normals>
struct Merge<Index, Normals>::Walk {
  const Cell& cell;
  const Patch& patch;
  Direction before;  // of the link walked last
  bool may_open = true;
  bool has_marker = false;
  uint8_t joins = 0;  // by link, a bit: its twin is on a boundary not spliced before
  Index region = no_record;
  Index first = no_record;
  Index current = no_record;
  Index twin[Patch::max_links];  // by link: the edge to splice with, or no_record

  Walk(const Cell& walked, const Patch& added)
      : cell(walked), patch(added), before(added.direction(0)) {}

  // From the link walked last into link i.
  int turn_into(int i) {
    const Direction from = before;
    before = patch.direction(i);
    return turn(patch.incidence, from, before);
  }
};

template <class Index, class Normals>
void Merge<Index, Normals>::start(Arena& arena, const Limits& limits, const Capacities& capacities,
                                  const PatchTable* table, bool spills) {
  const uint32_t columns = limits.columns();
  const uint32_t rows = limits.cell_rows();
  const uint32_t keys = Frontier<Index>::keys(columns, rows);
  halo_ = limits.halo();
  table_ = table;
  fragment_ = nullptr;
  (void)spills;
  frontier_.start(arena.take<Index>(Frontier<Index>::row_places(columns)), columns, rows);
  edges_.start(arena.take<Edge<Index, Normal>>(capacities.edges), capacities.edges);
  turns_ = counted_from_one(arena.take<uint8_t>(capacities.edges));
  fragments_.start(arena.take<RunNode<Index, Normal>>(capacities.runs), capacities.runs);
  ClosedRing<Index, Normal>* rings = arena.take<ClosedRing<Index, Normal>>(capacities.rings);
  regions_.start(arena.take<RegionNode<Index>>(capacities.regions), capacities.regions, rings,
                 capacities.rings);
  uint32_t* table_keys = arena.take<uint32_t>(capacities.slots);
  frontier_.table().start(table_keys, arena.take<Index>(capacities.slots), capacities.slots, keys);
  // No fewer than what makes every candidate a victim (should_spill()): so until all of them are
  // gone runs stay short, and a refused spill is taken up again.
  const uint32_t quarter = capacities.runs / 4;
  runs_kept_ = quarter > 2 * CellReserve::runs ? quarter : 2 * CellReserve::runs;
  const uint32_t in_slice = 2 * columns + 2;
  edges_kept_short_ = in_slice < capacities.edges / 8 ? in_slice : capacities.edges / 8;
}

template <class Index, class Normals>
void Merge<Index, Normals>::clear() {
  edges_.clear();
  fragments_.clear();
  regions_.clear();
  frontier_.table().clear();
  cuts_ = 0;
  splits_ = 0;
  touched_count_ = 0;
  is_delivering_ = false;
  next_fragment_ = 0;
}

template <class Index, class Normals>
HighWater Merge<Index, Normals>::high_water() const {
  return {edges_.high_water(), fragments_.high_water(), regions_.rings().high_water(),
          regions_.nodes().high_water(), frontier_.table().high_water()};
}

// ---- one cell ----

template <class Index, class Normals>
CellCounts Merge<Index, Normals>::take_cell(const Cell& cell) {
  touched_count_ = 0;
  // Without spills every edge that waits keeps two runs in reserve for the day it becomes boundary.
  const uint32_t waiting = edges_.in_use() + static_cast<uint32_t>(cell_bounds.ahead_links);
  boundary_only_ =
      cell.seals || (!spills_ && fragments_.available() < 2 * (CellReserve::runs + waiting));
  Index behind[behind_places];
  frontier_.gather(cell, table_->below[cell.configuration & 15], behind);
  CellCounts counts{0, 0};
  bool has_sectors = false;
  const uint32_t end = table_->first(cell.configuration + 1);
  for (uint32_t i = table_->first(cell.configuration); i < end; ++i) {
    const Patch patch = table_->at(i);
    take_patch(cell, patch, behind);
    counts.facets += patch.facets();
    counts.classic_triangles += patch.count - 2U;
    if (patch.kind == Patch::Kind::sectors) has_sectors = true;
  }
  // A loop of n links makes n - 2 triangles, but there are n sectors about the centroid.
  if (has_sectors) counts.classic_triangles -= 2;
  return counts;
}

template <class Index, class Normals>
void Merge<Index, Normals>::take_patch(const Cell& cell, const Patch& patch,
                                       const Index (&behind)[behind_places]) {
  Walk walk(cell, patch);
  meet_twins(walk, behind);
  if (cell.seals) return;
  begin_walk(walk);
  for (int i = walk.has_marker ? 0 : 1; i < patch.count; ++i) walk_link(walk, i);
  finish_walk(walk);
}

// Every edge that waits behind the patch is either a twin to splice with or becomes boundary now.
template <class Index, class Normals>
void Merge<Index, Normals>::meet_twins(Walk& walk, const Index (&behind)[behind_places]) {
  const Patch& patch = walk.patch;
  for (int i = 0; i < patch.count; ++i) {
    walk.twin[i] = no_record;
    const Index edge = is_behind(patch.place(i)) ? behind[patch.place(i)] : Index{no_record};
    if (edge == no_record) continue;
    const Index node = edges_[edge].region;
    const Incidence incidence = regions_.incidence(node);
    if (incidence == patch.incidence && !boundary_only_) {
      const Index root = regions_.root(node);
      walk.twin[i] = edge;
      if (root == walk.region) continue;
      walk.joins = static_cast<uint8_t>(walk.joins | 1 << i);
      walk.region = walk.region == no_record ? root : regions_.unite(walk.region, root);
    } else {
      if (incidence == patch.incidence && !walk.cell.seals) ++cuts_;
      const Link link = opposite_link(link_of(patch.incidence, patch.direction(i)));
      make_boundary(walk, i, edge, direction_of(incidence, link));
    }
  }
}

// Where link 0 is left open, it is done with.
template <class Index, class Normals>
void Merge<Index, Normals>::begin_walk(Walk& walk) {
  walk.may_open = !boundary_only_;
  if (walk.region == no_record) {
    // The reserve is for regions that are complete within the cell.
    if (regions_.nodes().available() <= CellReserve::regions) walk.may_open = false;
    walk.region = regions_.create(walk.patch.incidence);
  } else {
    regions_.refer(walk.region);
  }
  const Place place = walk.patch.place(0);
  walk.first = is_ahead(place) ? open_edge(walk, place) : Index{no_record};
  walk.has_marker = walk.first == no_record;
  if (walk.has_marker) walk.first = new_edge(walk.region);
  walk.current = walk.first;
  link(walk.first, walk.first);
}

template <class Index, class Normals>
void Merge<Index, Normals>::walk_link(Walk& walk, int i) {
  const Patch& patch = walk.patch;
  turn_by(walk.current, walk.turn_into(i));
  const Place place = patch.place(i);
  Index edge = no_record;
  if (walk.twin[i] != no_record && may_splice(walk, i)) {
    splice(walk, i);
  } else if (i > 0 && is_ahead(place) && (edge = open_edge(walk, place)) != no_record) {
    link(walk.current, edge);
    link(edge, walk.first);
    walk.current = edge;
  } else {
    meet_at(walk, i);
    append(walk.current, patch.direction(i));
  }
}

// A splice within one boundary splits it in two, and each will need a ring record in the end. When
// these run short the twin becomes boundary instead: the region stays one, with a slit in it.
template <class Index, class Normals>
bool Merge<Index, Normals>::may_splice(Walk& walk, int i) {
  const Index twin = walk.twin[i];
  const bool vanishes = twin == walk.current && edges_[twin].is_empty();
  if (vanishes || (walk.joins >> i & 1) != 0) return true;
  if (splits_ + CellReserve::rings < regions_.rings().capacity()) {
    ++splits_;
    return true;
  }
  ++cuts_;
  if (twin == walk.current) walk.current = edges_[twin].previous;
  const Patch& patch = walk.patch;
  make_boundary(walk, i, twin, opposite_direction(patch.incidence, patch.direction(i)));
  return false;
}

// Takes the twin out and goes on behind what came before it: the path so far is followed by what
// came after the twin, and what came before the twin by the path to come.
template <class Index, class Normals>
void Merge<Index, Normals>::splice(Walk& walk, int i) {
  const Index twin = walk.twin[i];
  const Edge<Index, Normal>& edge = edges_[twin];
  const Index previous = edge.previous;
  const int half_turn = direction_count(walk.patch.incidence) / 2;
  turn_by(twin, -half_turn);
  meet_at(walk, i);
  if (twin == walk.current) {
    if (!edge.is_empty()) close_ring(walk, i, twin);
  } else {
    join(walk.current, twin);
    if (previous != twin) link(walk.current, edge.next);
  }
  if (previous != twin) {
    link(previous, walk.first);
    walk.current = previous;
  }
  turn_by(walk.current, -half_turn);
  remove(twin);
}

template <class Index, class Normals>
void Merge<Index, Normals>::finish_walk(Walk& walk) {
  const Index current = walk.current;
  turn_by(current, walk.turn_into(0));
  if (walk.has_marker) {
    const Index marker = walk.first;
    meet_at(walk, 0);
    if (current != marker) {
      join(current, marker);
      link(current, edges_[marker].next);
    } else if (edges_[marker].is_empty()) {
      --splits_;  // this boundary has vanished inside the region
    } else {
      close_ring(walk, 0, marker);
    }
    remove(marker);
  }
  regions_.release(walk.region);
}

// ---- edges and fragments ----

template <class Index, class Normals>
Index Merge<Index, Normals>::new_edge(Index region) {
  const Index edge = edges_.take();
  edges_[edge].clear();
  edges_[edge].region = region;
  turns_[edge] = 0;
  regions_.refer(region);
  return edge;
}

// Leaves a link open for the neighbour to come, or cuts it for lack of room and returns no_record.
template <class Index, class Normals>
Index Merge<Index, Normals>::open_edge(const Walk& walk, Place place) {
  const Cell& cell = walk.cell;
  if (frontier_.is_border(place, cell)) return no_record;
  const bool above = place / 2 == face_above;
  const uint32_t kept = 1 + (above ? edges_kept_short_ : 0);  // one for a marker
  Index edge = no_record;
  if (walk.may_open && edges_.available() > kept) edge = new_edge(walk.region);
  if (above && edge != no_record && !frontier_.wait_above(place, cell, edge)) {
    remove(edge);
    edge = no_record;
  }
  if (!above) frontier_.in_slice(place, cell.column) = edge;
  if (edge == no_record) ++cuts_;
  return edge;
}

template <class Index, class Normals>
void Merge<Index, Normals>::remove(Index edge) {
  const Index region = edges_[edge].region;
  edges_[edge].clear();
  edges_.give(edge);
  regions_.release(region);
}

template <class Index, class Normals>
void Merge<Index, Normals>::link(Index edge, Index next) {
  edges_[edge].next = next;
  edges_[next].previous = edge;
}

// Puts the link of a waiting edge, the twin of the walk's link i, into its boundary.
template <class Index, class Normals>
void Merge<Index, Normals>::make_boundary(const Walk& walk, int i, Index edge,
                                          Direction direction) {
  const Index previous = edges_[edge].previous;
  meet_at(walk, i + 1);
  append(previous, direction);
  meet_at(walk, i);
  if (previous == edge) {
    close_ring(walk, i, edge);
  } else {
    join(previous, edge);
    link(previous, edges_[edge].next);
  }
  remove(edge);
}

// What append(), join() and close_ring() put together meets where the walk's link i begins.
template <class Index, class Normals>
void Merge<Index, Normals>::meet_at(const Walk& walk, int i) {
  if constexpr (Normals::hold_samples) normals().meet_at(start_of_link(walk, i, halo_));
}

template <class Index, class Normals>
void Merge<Index, Normals>::append(Index edge, Direction direction) {
  Edge<Index, Normal>& record = edges_[edge];
  fragments_.append(record, Run::straight(direction, 1));
  touch(edge, record, record.region, 0);
}

// Puts the fragment and the turn of `other` behind those of `edge`; the fragment of `other` is then
// void.
template <class Index, class Normals>
void Merge<Index, Normals>::join(Index edge, Index other) {
  turn_by(edge, turns_[other]);
  Edge<Index, Normal>& record = edges_[edge];
  fragments_.join(record, edges_[other]);
  touch(edge, record, record.region, 0);
}

template <class Index, class Normals>
void Merge<Index, Normals>::touch(Index index, const Fragment<Index, Normal>& fragment,
                                  Index region, uint8_t kind) {
  if (fragment.last == no_record) return;
  touched_[touched_count_++] = {index, static_cast<uint8_t>(regions_.incidence(region) | kind)};
}

// The fragment of an edge that is its own successor is a whole boundary, which begins and ends
// where the walk's link i begins.
template <class Index, class Normals>
void Merge<Index, Normals>::close_ring(const Walk& walk, int i, Index edge) {
  constexpr uint8_t negative = 0x80;
  Edge<Index, Normal>& record = edges_[edge];
  fragments_.close(record);
  const Index ring = regions_.add_ring(record.region, record, start_of_link(walk, i, halo_),
                                       (turns_[edge] & negative) != 0);
  touch(ring, record, record.region, is_ring);
}

}  // namespace discmc

#endif
