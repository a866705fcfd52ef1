#include <discmc/trace/corner_sweep.hpp>

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
  plain_.clear();
  is_suspended_ = false;
  keeps_corners_ = fragments().takes_whole_chains() && corners_.start(fragments().records());
}

void CornerSweep::forget() {
  plain_.forget();
  passes_ = {};
}

bool CornerSweep::sweep(const SweptRow& row, const NoNormals& normals, const Sink& sink,
                        Statistics& statistics) {
  if (keeps_corners_) {
    is_suspended_ = !sweep_corners(row, sink, statistics);
    if (is_suspended_) return false;
  }
  return keeps_corners_ || plain_.sweep(row, normals, sink, statistics);
}

// Sweeps a row, or the part of it before the fragments are handed over.
bool CornerSweep::sweep_corners(const SweptRow& row, const Sink& sink, Statistics& statistics) {
  if (is_suspended_) {
    if (!delivery().settle(fragments(), sink, statistics) || !deliver_rings(sink, statistics))
      return false;
  } else if (!passes_.begin_row(row)) {
    return true;
  }
  Records& records = fragments().records();
  SweepCounts counts = plain_.counts();
  while (passes_.find(row, counts)) {
    if (row.z >= CornerCode::most_slices || !corners_.make_room(records, passes_)) {
      corners_.hand_over(fragments(), row, passes_.first_word());
      plain_.go_on_from(passes_.first_word());
      keeps_corners_ = false;
      return true;
    }
    plain_.counts() = counts;
    corners_.take(records, passes_);
    if (!deliver_rings(sink, statistics)) return false;
  }
  counts.add_to(statistics);
  plain_.counts() = counts;
  return true;
}

// ---- rings ----

// Delivers the rings that close as chains that have met are joined. False when the sink said "not
// now".
bool CornerSweep::deliver_rings(const Sink& sink, Statistics& statistics) {
  Records& records = fragments().records();
  while (const uint32_t closed = corners_.close_ring(records)) {
    const Ring ring = ring_of(closed);
    bool is_done;
    if (is_hole(ring.code) ||
        delivery().has_holes_on(records, ring.code.incidence(), ring.code.vertex())) {
      put_out(ring);
      is_done = delivery().settle(fragments(), sink, statistics);
    } else {
      is_done = deliver(ring, sink, statistics);
    }
    corners_.give(records, ring.start, ring.corners);
    if (!is_done) return false;
  }
  return true;
}

// Finds where a ring begins, as Delivery does: at its last vertex, which is a corner.
CornerSweep::Ring CornerSweep::ring_of(uint32_t closed) const {
  const Records& records = fragments().records();
  Ring ring{closed, 0, CornerCode(0)};
  uint32_t at = closed;
  do {
    const Corner<uint32_t>& corner = records[at].corner;
    const CornerCode code = corner.code();
    if (code.bits() > ring.code.bits()) {
      ring.code = code;
      ring.start = at;
    }
    ++ring.corners;
    at = corner.next;
  } while (at != closed);
  return ring;
}

// Delivers a region that is one ring. When the sink says "not now" the ordinary delivery goes on.
bool CornerSweep::deliver(const Ring& ring, const Sink& sink, Statistics& statistics) {
  const Record<uint32_t, NoNormal>* const records = &fragments().records()[0];
  const Direction* const direction = directions.of[ring.code.incidence()];
  Event event{};
  event.incidence = ring.code.incidence();
  event.start = ring.code.vertex();
  uint32_t taken = 0;
  uint64_t links = 0;
  const auto tell = [&](Event::Kind kind) {
    event.kind = kind;
    if (sink.take(sink.context, event) != Answer::taken) return false;
    ++taken;
    return true;
  };
  const auto tell_runs = [&] {
    uint32_t next = ring.start;
    CornerCode code = ring.code;
    do {
      const CornerCode from = code;
      do {
        next = records[next].corner.next;
        code = records[next].corner.code();
      } while (code.onwards() == from.onwards());
      const uint32_t length = links_between(from, code);
      links += length;
      event.run = Run::straight(direction[from.onwards()], length);
      if (!tell(Event::Kind::run)) return false;
    } while (next != ring.start);
    return true;
  };
  if (!tell(Event::Kind::region) || !tell(Event::Kind::ring) || !tell_runs() ||
      !tell(Event::Kind::region_end)) {
    put_out(ring);
    delivery().go_on_behind(taken, fragments(), statistics);
    return false;
  }
  statistics.links += links;
  ++statistics.rings;
  ++statistics.regions;
  return true;
}

// Makes of a ring what goes out of the fragments.
void CornerSweep::put_out(const Ring& ring) {
  Records& records = fragments().records();
  auto& outgoing = fragments().outgoing();
  outgoing.kind = Outgoing<uint32_t>::Kind::ring;
  outgoing.incidence = ring.code.incidence();
  outgoing.start = ring.code.vertex();
  outgoing.last = no_record;
  uint32_t at = ring.start;
  do {
    const uint32_t next = records[at].corner.next;
    append_side(records, outgoing.last, records[at].corner.code(), records[next].corner.code());
    at = next;
  } while (at != ring.start);
}

}  // namespace discmc::trace
