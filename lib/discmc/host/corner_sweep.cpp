#include <discmc/host/corner_sweep.hpp>

namespace discmc::trace {

namespace {

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
  return turns_right(start.incidence(), direction[start.came()], direction[start.onwards()]);
}

}  // namespace

void CornerSweep::clear() {
  Plain::clear();
  passes_beyond_.clear();
  is_suspended_ = false;
  keeps_corners_ = corners_.start(slots());
}

void CornerSweep::forget_addresses() {
  Plain::forget_addresses();
  learnt_ = {};
}

bool CornerSweep::sweep(const SweptRow& row, const NoNormals& normals, const Sink& sink,
                        Statistics& statistics) {
  if (row.role == SlabRole::below_slab) {
    open_seam(row);
    return true;
  }
  if (keeps_corners_) {
    is_suspended_ =
        !(row.is_own() ? sweep_corners(row, sink, statistics) : close_seam(row, sink, statistics));
    if (is_suspended_) return false;
  }
  if (keeps_corners_) return true;
  // What comes from below a slab waits, or was counted as lost.
  SweptRow rest = row;
  if (row.is_own()) rest.role = SlabRole::inside;
  return Plain::sweep(rest, normals, sink, statistics);
}

// ---- seams ----

// Sweeps a row of the slice below a slab. Whether a link that leads up from it is boundary depends
// on the cells above alone, which take part: so all ends are there that those of the slab wait for.
void CornerSweep::open_seam(const SweptRow& row) {
  while (passes_beyond_.find(row, counts_)) {
    constexpr uint32_t most = Corners::max_cut;
    if (keeps_corners_ &&
        (row.z >= CornerCode::max_slices || !corners_.make_room(slots(), most, most)))
      hand_over(row, 0);
    for (; passes_beyond_.has_next(); passes_beyond_.advance()) {
      const Pass& pass = passes_beyond_.pass();
      if (keeps_corners_) {
        corners_.cut_at_seam(slots(), pass, passes_beyond_.vertex());
      } else {
        if (pass.in >= first_rising_queue) fragments_.push_lost(pass.in);
        if (pass.out >= first_rising_queue) fragments_.push_lost(pass.out);
      }
    }
  }
}

// Sweeps a row of the slice above a slab: once, as a corner tells where the end is that waits.
bool CornerSweep::close_seam(const SweptRow& row, const Sink& sink, Statistics& statistics) {
  if (is_suspended_ && !go_on_delivering(sink, statistics)) return false;
  do {
    while (passes_beyond_.has_next()) {
      corners_.cut_at_seam(slots(), passes_beyond_.pass(), passes_beyond_.vertex());
      passes_beyond_.advance();
      if (!deliver_chains(sink, statistics)) return false;
    }
  } while (passes_beyond_.find(row, counts_));
  return true;
}

// ---- own slices ----

// Sweeps a row, or the part of it before the fragments are handed over.
bool CornerSweep::sweep_corners(const SweptRow& row, const Sink& sink, Statistics& statistics) {
  if (is_suspended_) {
    if (!go_on_delivering(sink, statistics)) return false;
  } else if (!learnt_.begin_row(row)) {
    return true;
  }
  SweepCounts counts = counts_;
  while (learnt_.find(row, counts)) {
    if (row.z >= CornerCode::max_slices ||
        !corners_.make_room(slots(), learnt_.count(), learnt_.edges())) {
      hand_over(row, learnt_.first_word());
      passes_.go_on_from(learnt_.first_word());
      return true;
    }
    counts_ = counts;
    corners_.take(slots(), learnt_);
    if (!deliver_chains(sink, statistics)) return false;
  }
  counts.add_to(statistics);
  counts_ = counts;
  return true;
}

void CornerSweep::hand_over(const SweptRow& row, uint32_t word) {
  corners_.hand_over(fragments_, row, word);
  keeps_corners_ = false;
}

// ---- closed chains ----

bool CornerSweep::go_on_delivering(const Sink& sink, Statistics& statistics) {
  return delivery_.settle(fragments_, sink, statistics) && deliver_chains(sink, statistics);
}

// Delivers the chains that close as those that have met are joined. False when the sink said "not
// now".
bool CornerSweep::deliver_chains(const Sink& sink, Statistics& statistics) {
  while (const uint32_t closed = corners_.close_chain(slots())) {
    const Chain chain = chain_of(closed);
    bool is_done;
    if (chain.code.begins_at_seam() || is_hole(chain.code) || may_have_holes(chain)) {
      put_out(chain);
      is_done = delivery_.settle(fragments_, sink, statistics);
    } else {
      is_done = deliver(chain, sink, statistics);
    }
    corners_.give(slots(), chain.start, chain.corners);
    if (!is_done) return false;
  }
  return true;
}

// Whether holes wait on the plane of a ring.
bool CornerSweep::may_have_holes(const Chain& ring) const {
  const auto& holes = delivery_.holes();
  return holes.count() > 0 &&
         holes.has_any(fragments_.slots(), ring.code.incidence(), ring.code.vertex());
}

// Finds where a chain begins: a ring at its last vertex, which is a corner, as Delivery does, and a
// fragment at the corner that is named.
CornerSweep::Chain CornerSweep::chain_of(uint32_t closed) {
  Slot<uint32_t, NoNormal>* const slots = &fragments_.slots()[0];
  Chain chain{closed, 0, CornerSlot(slots[closed]).code()};
  uint64_t last = chain.code.begins_at_seam() ? UINT64_MAX : chain.code.bits();
  uint32_t at = closed;
  do {
    const CornerSlot corner(slots[at]);
    const CornerCode code = corner.code();
    if (code.bits() > last) {
      last = code.bits();
      chain.code = code;
      chain.start = at;
    }
    ++chain.corners;
    at = corner.next();
  } while (at != closed);
  return chain;
}

// Delivers a region that is one ring. When the sink says "not now" the ordinary delivery goes on.
bool CornerSweep::deliver(const Chain& ring, const Sink& sink, Statistics& statistics) {
  Slot<uint32_t, NoNormal>* const slots = &fragments_.slots()[0];
  const Direction* const direction = directions.of[ring.code.incidence()];
  Event event{};
  event.incidence = ring.code.incidence();
  event.start = ring.code.vertex();
  uint32_t taken = 0;
  uint64_t links = 0;
  const auto send = [&](Event::Kind kind) {
    event.kind = kind;
    if (sink.take(sink.context, event) != SinkResult::accepted) return false;
    ++taken;
    return true;
  };
  const auto send_runs = [&] {
    uint32_t next = ring.start;
    CornerCode code = ring.code;
    do {
      const CornerCode from = code;
      do {
        next = CornerSlot(slots[next]).next();
        code = CornerSlot(slots[next]).code();
      } while (code.onwards() == from.onwards());
      const uint32_t length = links_between(from, code);
      links += length;
      event.run = Run::straight(direction[from.onwards()], length);
      if (!send(Event::Kind::run)) return false;
    } while (next != ring.start);
    return true;
  };
  if (!send(Event::Kind::region) || !send(Event::Kind::ring) || !send_runs() ||
      !send(Event::Kind::region_end)) {
    put_out(ring);
    delivery_.begin(fragments_);
    for (; taken > 0; --taken) delivery_.go_on(fragments_, statistics);
    return false;
  }
  statistics.links += links;
  ++statistics.rings;
  ++statistics.regions;
  return true;
}

// Makes of a closed chain what goes out of the fragments.
void CornerSweep::put_out(const Chain& chain) {
  using Kind = Outgoing<uint32_t>::Kind;
  Slots& slots = fragments_.slots();
  const CornerCode start = chain.code;
  auto& outgoing = fragments_.outgoing();
  outgoing.kind = start.begins_at_seam() ? Kind::fragment : Kind::ring;
  outgoing.incidence = start.incidence();
  outgoing.start = start.vertex();
  outgoing.incoming = discmc::direction_of(start.incidence(), start.onwards());
  outgoing.last = no_slot;
  uint32_t at = chain.start;
  do {
    const CornerSlot corner(slots[at]);
    const CornerSlot next(slots[corner.next()]);
    append_side(slots, outgoing.last, corner.code(), next.code());
    at = corner.next();
  } while (at != chain.start && !CornerSlot(slots[at]).code().ends_at_seam());
}

}  // namespace discmc::trace
