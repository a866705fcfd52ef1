#include <discmc/host/sweep.hpp>

namespace discmc::host {

namespace {

using trace::SlabRole;

/// What SectorTable::direction() tells of links that lie in a plane, a byte each: it is asked for
/// every run.
struct Directions {
  Direction of[incidence_codes][link_codes];
};
constexpr Directions directions_of_links() {
  Directions directions{};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (Direction i = 0; i < direction_count(incidence); ++i)
      directions.of[incidence][link_of(incidence, i)] = i;
  return directions;
}
constexpr Directions directions = directions_of_links();

bool is_hole(CornerCode start) {
  const Direction* const direction = directions.of[start.incidence()];
  return trace::turns_right(start.incidence(), direction[start.incoming()],
                            direction[start.onwards()]);
}

}  // namespace

void Sweep::clear() {
  Plain::clear();
  edges_.clear();
  below_waits_ = false;
  handed_word_ = 0;
  keeps_nodes_ = chains_.start(slots());
}

bool Sweep::sweep(const trace::SweptRow& row, const NoNormals& normals, const Sink& sink,
                  Statistics& statistics) {
  while (keeps_nodes_) {
    if (!deliver(sink, statistics)) return false;
    if (edges_.is_empty() && !make_room(row)) {
      if (!chains_.has_complete()) hand_over(row);
    } else if (edges_.collect(row)) {
      take_edges(statistics);
    } else {
      return true;
    }
  }
  return sweep_plain(row, normals, sink, statistics);
}

bool Sweep::flush(const Sink& sink, Statistics& statistics) {
  if (!keeps_nodes_) return true;
  if (!deliver(sink, statistics)) return false;
  take_edges(statistics);
  return deliver(sink, statistics);
}

bool Sweep::settle_holes(const Sink& sink, Statistics& statistics) {
  if (keeps_nodes_) {
    if (!flush(sink, statistics)) return false;
    chains_.find_complete(slots());
    if (!deliver(sink, statistics)) return false;
  }
  return Plain::settle_holes(sink, statistics);
}

void Sweep::take_edges(Statistics& statistics) {
  found_.find(edges_, counts_);
  counts_.add_to(statistics);
  chains_.take(slots(), found_, edges_.count());
  edges_.take_all();
}

// ---- handing over ----

// False when there is none, and all fragments that are complete have been found.
bool Sweep::make_room(const trace::SweptRow& row) {
  if (row.z < CornerCode::max_slices && chains_.make_room(slots())) return true;
  chains_.find_complete(slots());
  return false;
}

// Below a slab there are only ends of others, which are lost to firmware's sweep.
void Sweep::hand_over(const trace::SweptRow& row) {
  keeps_nodes_ = false;
  if (row.role == SlabRole::below_slab) return chains_.give_all(slots());
  below_waits_ = true;
  handed_word_ = edges_.word();
  passes_.go_on_from(handed_word_);
  chains_.hand_over(fragments_, row, handed_word_);
}

bool Sweep::sweep_plain(const trace::SweptRow& row, const NoNormals& normals, const Sink& sink,
                        Statistics& statistics) {
  trace::SweptRow rest = row;
  if (below_waits_ && row.is_own()) rest.role = SlabRole::inside;
  if (row.role == SlabRole::above_slab && handed_word_ > 0) {
    // It is swept twice, either time from there.
    fragments_.set_below_is_lost(false);
    if (!chains_are_ended_) {
      if (!take_passes(row, normals, sink, statistics)) return false;
      chains_are_ended_ = true;
      passes_.go_on_from(handed_word_);
    }
    if (!take_passes(row, normals, sink, statistics)) return false;
    chains_are_ended_ = false;
  } else if (!Plain::sweep(rest, normals, sink, statistics)) {
    return false;
  }
  handed_word_ = 0;
  return true;
}

// ---- delivery ----

bool Sweep::deliver(const Sink& sink, Statistics& statistics) {
  if (!delivery_.settle(fragments_, sink, statistics)) return false;
  while (chains_.find_ring(slots()))
    if (!deliver_ring(sink, statistics)) return false;
  while (chains_.put_out_complete(fragments_))
    if (!delivery_.settle(fragments_, sink, statistics)) return false;
  return true;
}

// Whether holes wait on the plane of a ring.
bool Sweep::has_holes_on_plane(CornerCode corner) const {
  const auto& holes = delivery_.holes();
  return holes.count() > 0 &&
         holes.has_any(fragments_.slots(), corner.incidence(), corner.vertex());
}

// Delivers the ring that was found. When the sink says "not now" the ordinary delivery goes on.
bool Sweep::deliver_ring(const Sink& sink, Statistics& statistics) {
  const uint32_t count = chains_.corner_count();
  uint64_t* const corner = chains_.corners();
  // It begins at its last vertex, as in Delivery: a corner.
  uint64_t last = 0;
  uint32_t first = 0;
  uint64_t links = 0;
  if (count > 0) {
    corner[count] = corner[0];
    const Direction* const direction = directions.of[CornerCode(corner[0]).incidence()];
    for (uint32_t i = 0; i < count; ++i) {
      const CornerCode from(corner[i]);
      const uint32_t length = links_between(from, CornerCode(corner[i + 1]));
      run_[i] = run_[count + i] = Run::straight(direction[from.onwards()], length);
      links += length;
      if (corner[i] > last) {
        last = corner[i];
        first = i;
      }
    }
  }
  const CornerCode start(last);
  if (count == 0 || is_hole(start) || has_holes_on_plane(start)) {
    chains_.put_out_ring(fragments_);
    return delivery_.settle(fragments_, sink, statistics);
  }
  Event event{};
  event.incidence = start.incidence();
  event.start = start.vertex();
  uint32_t taken = 0;
  const auto send = [&](Event::Kind kind) {
    event.kind = kind;
    if (sink.take(sink.context, event) != SinkResult::accepted) return false;
    ++taken;
    return true;
  };
  const auto send_runs = [&] {
    for (uint32_t i = 0; i < count; ++i) {
      event.run = run_[first + i];
      if (!send(Event::Kind::run)) return false;
    }
    return true;
  };
  if (!send(Event::Kind::region) || !send(Event::Kind::ring) || !send_runs() ||
      !send(Event::Kind::region_end)) {
    chains_.put_out_ring(fragments_);
    delivery_.begin(fragments_);
    for (; taken > 0; --taken) delivery_.go_on(fragments_, statistics);
    return false;
  }
  statistics.links += links;
  ++statistics.rings;
  ++statistics.regions;
  return true;
}

}  // namespace discmc::host
