#include <discmc/merge.hpp>

namespace discmc {

// A patch's ring under construction. It is closed at all times: `current`, whose fragment grows, is
// followed by `first`. When link 0 is not left open, `first` is a marker, an edge without a link
// that finish_walk() takes out again.
template <class Index>
struct Merge<Index>::Walk {
  const Cell& cell;
  const Patch& patch;
  int half_turn;
  bool may_open;
  bool has_marker;
  Index region;
  Index first;
  Index current;
  Index twin[Patch::max_links];  // by link: the edge to splice with, or none
  bool joins[Patch::max_links];  // whether that edge is on a boundary not spliced before

  Vertex start_of(int i) const {
    Vertex vertex = cell.origin + position(patch.start);
    for (int l = 0; l < i; ++l)
      vertex = vertex + direction_vector(patch.incidence, patch.direction(l));
    return vertex;
  }
  uint8_t turn_into(int i) const { return static_cast<uint8_t>(patch.turn[i]); }
};

template <class Index>
void Merge<Index>::start(Arena& arena, const Limits& limits, const Capacities& capacities,
                         const PatchTable& table, bool spills) {
  const uint32_t columns = limits.columns();
  const uint32_t keys = Frontier<Index>::keys(columns, limits.cell_rows());
  table_ = &table;
  spills_ = spills;
  frontier_.start(arena.take<Index>(Frontier<Index>::row_places(columns)), columns);
  edges_.start(arena.take<Edge<Index>>(capacities.edges), capacities.edges);
  turns_ = arena.take<uint8_t>(capacities.edges);
  fragments_.start(arena.take<RunNode<Index>>(capacities.runs), capacities.runs);
  ClosedRing<Index>* rings = arena.take<ClosedRing<Index>>(capacities.rings);
  regions_.start(arena.take<RegionNode<Index>>(capacities.regions), capacities.regions, rings,
                 capacities.rings);
  uint32_t* stamps = arena.take<uint32_t>(capacities.slots);
  frontier_.table().start(stamps, arena.take<Index>(capacities.slots), capacities.slots,
                          keys > 0 ? keys : 1);
  // No fewer than what makes every candidate a victim (should_spill()): so until all of them are
  // gone runs stay short, and a refused spill is taken up again.
  const uint32_t quarter = capacities.runs / 4;
  runs_kept_ = quarter > 2 * CellReserve::runs ? quarter : 2 * CellReserve::runs;
  const uint32_t in_slice = 2 * columns + 2;
  edges_kept_short_ = in_slice < capacities.edges / 8 ? in_slice : capacities.edges / 8;
  clear();
}

template <class Index>
void Merge<Index>::clear() {
  edges_.clear();
  fragments_.clear();
  regions_.clear();
  frontier_.table().clear();
  cuts_ = 0;
  splits_ = 0;
  touched_edges_ = 0;
  touched_rings_ = 0;
  stage_ = Stage::begin;
  next_fragment_ = 0;
}

template <class Index>
HighWater Merge<Index>::high_water() const {
  return {edges_.high_water(), fragments_.high_water(), regions_.rings().high_water(),
          regions_.nodes().high_water(), frontier_.table().high_water()};
}

// ---- one cell ----

template <class Index>
void Merge<Index>::take_cell(const Cell& cell) {
  touched_edges_ = 0;
  touched_rings_ = 0;
  // Without spills every edge that waits keeps two runs in reserve for the day it becomes boundary.
  const uint32_t waiting = edges_.in_use() + static_cast<uint32_t>(cell_bounds.ahead_links);
  boundary_only_ = !spills_ && fragments_.available() < 2 * (CellReserve::runs + waiting);
  Index behind[behind_places];
  frontier_.gather(cell.column, cell.row, table_->below[cell.configuration & 15], behind);
  const uint32_t end = table_->first[cell.configuration + 1];
  for (uint32_t i = table_->first[cell.configuration]; i < end; ++i)
    take_patch(cell, table_->patch[table_->index[i]], behind);
}

template <class Index>
void Merge<Index>::seal_cell(const Cell& cell) {
  touched_edges_ = 0;
  touched_rings_ = 0;
  Index behind[behind_places];
  frontier_.gather(cell.column, cell.row, table_->below[cell.configuration & 15], behind);
  const uint32_t end = table_->first[cell.configuration + 1];
  for (uint32_t i = table_->first[cell.configuration]; i < end; ++i) {
    const Patch& patch = table_->patch[table_->index[i]];
    Vertex position = cell.origin + discmc::position(patch.start);
    for (int l = 0; l < patch.count; ++l) {
      const Link link = links.link[patch.incidence][patch.direction(l)];
      const Index edge = patch.place(l) / 2 == face_below ? behind[patch.place(l)] : none;
      if (edge != none) {
        const Incidence incidence = regions_.incidence(edges_[edge].region);
        make_boundary(edge, links.direction[incidence][opposite_link(link)], position);
      }
      position = position + links.vector[link];
    }
  }
}

template <class Index>
void Merge<Index>::take_patch(const Cell& cell, const Patch& patch,
                              const Index (&behind)[behind_places]) {
  Walk walk{cell,
            patch,
            links.direction_count[patch.incidence] / 2,
            !boundary_only_,
            false,
            none,
            none,
            none,
            {},
            {}};
  meet_twins(walk, behind);
  if (walk.region == none) {
    // The reserve is for regions that are complete within the cell.
    if (regions_.nodes().available() <= CellReserve::regions) walk.may_open = false;
    walk.region = regions_.create(patch.incidence);
  } else {
    regions_.refer(walk.region);
  }
  walk.first = is_ahead(patch.place(0)) ? open_edge(walk, patch.place(0)) : none;
  walk.has_marker = walk.first == none;
  if (walk.has_marker) walk.first = new_edge(walk.region);
  walk.current = walk.first;
  link(walk.first, walk.first);
  if (walk.has_marker) {
    if (walk.twin[0] != none && may_splice(walk, 0))
      splice(walk, 0);
    else
      append(walk.current, patch.direction(0));
  }
  for (int i = 1; i < patch.count; ++i) walk_link(walk, i);
  finish_walk(walk);
}

// Every edge that waits behind the patch is either a twin to splice with or becomes boundary now.
template <class Index>
void Merge<Index>::meet_twins(Walk& walk, const Index (&behind)[behind_places]) {
  const Patch& patch = walk.patch;
  for (int i = 0; i < patch.count; ++i) {
    const Index edge = is_behind(patch.place(i)) ? behind[patch.place(i)] : none;
    walk.twin[i] = none;
    if (edge != none) {
      const Index node = edges_[edge].region;
      const Incidence incidence = regions_.incidence(node);
      if (incidence == patch.incidence && !boundary_only_) {
        const Index root = regions_.root(node);
        walk.twin[i] = edge;
        walk.joins[i] = root != walk.region;
        if (walk.region == none)
          walk.region = root;
        else if (root != walk.region)
          walk.region = regions_.unite(walk.region, root);
      } else {
        if (incidence == patch.incidence) ++cuts_;
        const Link link = opposite_link(links.link[patch.incidence][patch.direction(i)]);
        make_boundary(edge, links.direction[incidence][link], walk.start_of(i));
      }
    }
  }
}

template <class Index>
void Merge<Index>::walk_link(Walk& walk, int i) {
  turns_[walk.current] = static_cast<uint8_t>(turns_[walk.current] + walk.turn_into(i));
  if (walk.twin[i] != none) {
    if (may_splice(walk, i)) return splice(walk, i);
  } else if (is_ahead(walk.patch.place(i))) {
    const Index edge = open_edge(walk, walk.patch.place(i));
    if (edge != none) {
      link(walk.current, edge);
      link(edge, walk.first);
      walk.current = edge;
      return;
    }
  }
  append(walk.current, walk.patch.direction(i));
}

// A splice within one boundary splits it in two, and each will need a ring record in the end. When
// these run short the twin becomes boundary instead: the region stays one, with a slit in it.
template <class Index>
bool Merge<Index>::may_splice(Walk& walk, int i) {
  const Index twin = walk.twin[i];
  const bool vanishes = twin == walk.current && edges_[twin].is_empty();
  if (walk.joins[i] || vanishes) return true;
  if (splits_ + CellReserve::rings < regions_.rings().capacity()) {
    ++splits_;
    return true;
  }
  ++cuts_;
  if (twin == walk.current) walk.current = edges_[twin].previous;
  const Link link = opposite_link(links.link[walk.patch.incidence][walk.patch.direction(i)]);
  make_boundary(twin, links.direction[walk.patch.incidence][link], walk.start_of(i));
  return false;
}

// Takes the twin out and goes on behind what came before it: the path so far is followed by what
// came after the twin, and what came before the twin by the path to come.
template <class Index>
void Merge<Index>::splice(Walk& walk, int i) {
  const Index twin = walk.twin[i];
  const Edge<Index>& edge = edges_[twin];
  const Index previous = edge.previous;
  const uint8_t turn = static_cast<uint8_t>(turns_[twin] - walk.half_turn);
  if (twin == walk.current) {
    if (!edge.is_empty()) close_ring(walk.region, edge, turn, walk.start_of(i));
    link(previous, walk.first);
    walk.current = previous;
  } else {
    turns_[walk.current] = static_cast<uint8_t>(turns_[walk.current] + turn);
    join(walk.current, edge);
    if (previous != twin) {
      link(walk.current, edge.next);
      link(previous, walk.first);
      walk.current = previous;
    }
  }
  turns_[walk.current] = static_cast<uint8_t>(turns_[walk.current] - walk.half_turn);
  remove(twin);
}

template <class Index>
void Merge<Index>::finish_walk(Walk& walk) {
  const Index current = walk.current;
  turns_[current] = static_cast<uint8_t>(turns_[current] + walk.turn_into(0));
  if (walk.has_marker) {
    const Index marker = walk.first;
    Edge<Index>& edge = edges_[marker];
    if (current != marker) {
      turns_[current] = static_cast<uint8_t>(turns_[current] + turns_[marker]);
      join(current, edge);
      link(current, edge.next);
    } else if (edge.is_empty()) {
      --splits_;  // this boundary has vanished inside the region
    } else {
      close_ring(walk.region, edge, turns_[marker], walk.start_of(0));
    }
    remove(marker);
  }
  regions_.release(walk.region);
}

// ---- edges and fragments ----

template <class Index>
Index Merge<Index>::new_edge(Index region) {
  const Index edge = edges_.take();
  edges_[edge].clear();
  edges_[edge].region = region;
  turns_[edge] = 0;
  regions_.refer(region);
  return edge;
}

// Leaves a link open for the neighbour to come, or cuts it for lack of room and returns none.
template <class Index>
Index Merge<Index>::open_edge(const Walk& walk, Place place) {
  const Cell& cell = walk.cell;
  if (place / 2 == face_right && !cell.has_right) return none;
  if (place / 2 == face_back && !cell.has_back) return none;
  const bool above = place / 2 == face_above;
  const uint32_t kept = 1 + (above ? edges_kept_short_ : 0);  // one for a marker
  Index edge = none;
  if (walk.may_open && edges_.available() > kept) edge = new_edge(walk.region);
  if (!above) {
    frontier_.wait_in_slice(place, cell.column, edge);
  } else if (edge != none && !frontier_.wait_above(place, cell.column, cell.row, edge)) {
    remove(edge);
    edge = none;
  }
  if (edge == none) ++cuts_;
  return edge;
}

template <class Index>
void Merge<Index>::remove(Index edge) {
  const Index region = edges_[edge].region;
  edges_[edge].clear();
  edges_.give(edge);
  regions_.release(region);
}

// Puts the link of a waiting edge into its boundary. `end` is where that link ends.
template <class Index>
void Merge<Index>::make_boundary(Index edge, Direction direction, const Vertex& end) {
  Edge<Index>& record = edges_[edge];
  const Index previous = record.previous;
  append(previous, direction);
  if (previous == edge) {
    close_ring(record.region, record, turns_[edge], end);
  } else {
    turns_[previous] = static_cast<uint8_t>(turns_[previous] + turns_[edge]);
    join(previous, record);
    link(previous, record.next);
  }
  remove(edge);
}

template <class Index>
void Merge<Index>::append(Index edge, Direction direction) {
  Edge<Index>& record = edges_[edge];
  fragments_.append(record, Run::straight(direction, 1));
  if (record.last != none)
    touched_edge_[touched_edges_++] = {edge, regions_.incidence(record.region)};
}

template <class Index>
void Merge<Index>::join(Index edge, const Fragment<Index>& other) {
  Edge<Index>& record = edges_[edge];
  fragments_.join(record, other);
  if (record.last != none)
    touched_edge_[touched_edges_++] = {edge, regions_.incidence(record.region)};
}

template <class Index>
void Merge<Index>::close_ring(Index region, const Fragment<Index>& fragment, uint8_t turn,
                              const Vertex& start) {
  constexpr uint8_t negative = 0x80;
  const Index ring = regions_.add_ring(region, fragment, start, (turn & negative) != 0);
  touched_ring_[touched_rings_++] = {ring, regions_.incidence(region)};
}

template class Merge<uint16_t>;
template class Merge<uint32_t>;

}  // namespace discmc
