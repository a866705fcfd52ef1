// A ring delivered in one go, from a copy of its runs in one array: for hosts, which have stack.
//
// The events are those that Delivery sends one by one. Where the sink says "not now" that goes on.
#ifndef DISCMC_TRACE_FLAT_RING_HPP
#define DISCMC_TRACE_FLAT_RING_HPP

#include <discmc/trace/delivery.hpp>

namespace discmc::trace {

/// A way in one number: x, y and z in 21, 21 and 22 bits, so that the order of numbers is the order
/// z, y, x. Limit: less than 2^20 half-steps in x and y, 2^21 in z.
using PackedWay = int64_t;

namespace derive {
struct PackedSteps {
  PackedWay of[incidence_codes][8];
};
constexpr PackedSteps packed_steps() {
  PackedSteps steps{};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (Direction i = 0; i < direction_count(incidence); ++i) {
      const Vertex v = direction_vector(incidence, i);
      steps.of[incidence][i] = v.x + v.y * (PackedWay{1} << 21) + v.z * (PackedWay{1} << 42);
    }
  return steps;
}
}  // namespace derive
/// A link, by incidence and direction.
inline constexpr derive::PackedSteps packed_steps = derive::packed_steps();

inline Vertex unpacked(PackedWay way) {
  constexpr PackedWay one = 1 << 21;
  const auto lowest = [](PackedWay from) {
    return static_cast<int32_t>(((from + one / 2) & (one - 1)) - one / 2);
  };
  const int32_t x = lowest(way);
  way = (way - x) / one;
  const int32_t y = lowest(way);
  return {x, y, static_cast<int32_t>((way - y) / one)};
}

template <class Index, class Normal>
class FlatRing {
 public:
  using Slot = typename RunRecord<Index, Normal>::Slot;

  /// Copies the runs of a list. False when they are too many.
  bool load(const Pool<Record<Index, Normal>, Index>& records, Index last);
  /// Finds where to begin, as Delivery does.
  void find_start(Incidence incidence);

  /// Of the ring from its start on. Limit: after find_start().
  bool is_hole() const { return is_hole_; }
  Direction came() const { return came_; }
  /// From where the list begins.
  Vertex way_to_start() const { return unpacked(way_to_start_); }
  uint32_t start() const { return start_; }
  uint32_t next(uint32_t place) const { return place + 1 == count_ ? 0 : place + 1; }
  const Slot& operator[](uint32_t place) const { return slot_[place]; }

 private:
  static constexpr uint32_t most_runs = 64;
  static constexpr uint32_t slots = RunRecord<Index, Normal>::slots;

  uint32_t count_ = 0;
  uint32_t start_ = 0;
  Direction came_ = 0;
  bool is_hole_ = false;
  PackedWay way_to_start_ = 0;
  Slot slot_[most_runs + slots];
};

template <class Index, class Normal>
bool FlatRing<Index, Normal>::load(const Pool<Record<Index, Normal>, Index>& records, Index last) {
  Index index = last;
  uint32_t count = 0;
  do {
    index = records[index].linked.next;
    for (const Slot& slot : records[index].runs.slot) {
      slot_[count] = slot;
      count += slot.run != 0 ? 1 : 0;
    }
  } while (index != last && count <= most_runs);
  count_ = count;
  return index == last;
}

template <class Index, class Normal>
void FlatRing<Index, Normal>::find_start(Incidence incidence) {
  const uint32_t ascending = ascending_directions.of[incidence];
  const PackedWay* const steps = packed_steps.of[incidence];
  constexpr PackedWay before_all = INT64_MIN;
  PackedWay way = 0;
  PackedWay last = before_all;
  Direction before = direction_of(slot_[count_ - 1].run);
  for (uint32_t i = 0; i < count_; ++i) {
    const Direction direction = direction_of(slot_[i].run);
    const bool is_top = (ascending >> before & ~(ascending >> direction) & 1) != 0;
    if (is_top && way > last) {
      last = way;
      start_ = i;
      came_ = before;
    }
    way += steps[direction] * static_cast<PackedWay>(length_of(slot_[i].run));
    before = direction;
  }
  way_to_start_ = last;
  is_hole_ = turns_right(incidence, came_, direction_of(slot_[start_].run));
}

template <class Index, class Normal>
bool Delivery<Index, Normal>::settle_at_once(Chains& chains, const Sink& sink,
                                             Statistics& statistics) {
  Records& records = chains.records();
  Out& out = chains.outgoing();
  FlatRing<Index, Normal> ring;
  if (is_delivering_ || out.kind != Out::Kind::ring || !ring.load(records, out.last))
    return settle(chains, sink, statistics);
  ring.find_start(out.incidence);
  if (ring.is_hole() || (holes_.count() > 0 && holes_.mark(records, out) > 0))
    return settle(chains, sink, statistics);

  uint32_t taken = 0;
  uint64_t links = 0;
  event_.incidence = out.incidence;
  event_.came = ring.came();
  event_.hole = false;
  event_.start = out.start + ring.way_to_start();
  const auto tell = [&](Event::Kind kind) {
    event_.kind = kind;
    if (sink.take(sink.context, event_) != Answer::taken) return false;
    ++taken;
    return true;
  };
  const auto tell_runs = [&] {
    uint32_t place = ring.start();
    do {
      event_.run = long_run(ring[place].run);
      if constexpr (sizeof(Slot) > sizeof(ShortRun)) event_.normal = ring[place].normal();
      do place = ring.next(place);
      while (place != ring.start() && event_.run.absorb(long_run(ring[place].run)));
      if (!tell(Event::Kind::run)) return false;
      links += event_.run.length();
    } while (place != ring.start());
    return true;
  };
  if (tell(Event::Kind::region) && tell(Event::Kind::ring) && tell_runs() &&
      tell(Event::Kind::region_end)) {
    Lists::give(records, out.last);
    out.kind = Out::Kind::none;
    statistics.links += links;
    ++statistics.rings;
    ++statistics.regions;
    return true;
  }
  begin(chains);
  for (; taken > 0; --taken) go_on(chains, statistics);
  return false;
}

}  // namespace discmc::trace

#endif
