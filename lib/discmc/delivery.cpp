// The merge's side towards the sink, between cells: complete regions go out, and fragments early.
#include <discmc/merge.hpp>

namespace discmc {

template <class Index>
bool Merge<Index>::settle(const Sink& sink, Statistics& statistics) {
  while (regions_.has_complete())
    if (!deliver_region(sink, statistics)) return false;
  return !spills_ || spill_touched(sink, statistics);
}

static bool offer(const Sink& sink, const Event& event) {
  return sink.take(sink.context, event) == Answer::taken;
}

template <class Index>
bool Merge<Index>::deliver_region(const Sink& sink, Statistics& statistics) {
  const Index region = regions_.first_complete();
  const Index last = regions_.rings_outer_first(region);
  Event event{};
  event.incidence = regions_.incidence(region);
  if (stage_ == Stage::begin) {
    event.kind = Event::Kind::region;
    if (!offer(sink, event)) return false;
    ring_ = regions_.ring(last).next;
    stage_ = Stage::ring;
  }
  while (stage_ != Stage::end) {
    ClosedRing<Index>& ring = regions_.ring(ring_);
    if (stage_ == Stage::ring) {
      event.kind = Event::Kind::ring;
      event.start = regions_.start_of(ring);
      event.hole = ring.hole != 0;
      if (!offer(sink, event)) return false;
      node_ = fragments_.first(ring);
      stage_ = Stage::runs;
    }
    if (!deliver_runs(sink, ring, statistics)) return false;
    fragments_.give_nodes(ring);
    stage_ = ring_ == last ? Stage::end : Stage::ring;
    ring_ = ring.next;
  }
  Event end{};
  end.kind = Event::Kind::region_end;
  end.incidence = event.incidence;
  if (!offer(sink, end)) return false;
  stage_ = Stage::begin;
  const uint32_t rings = regions_.remove_first_complete();
  splits_ -= rings - 1;
  statistics.rings += rings;
  ++statistics.regions;
  return true;
}

template <class Index>
bool Merge<Index>::deliver_runs(const Sink& sink, const Fragment<Index>& fragment,
                                Statistics& statistics) {
  Event event{};
  event.kind = Event::Kind::run;
  for (bool in_place = false; !in_place;) {
    in_place = node_ == none;
    event.run = in_place ? fragment.tail : fragments_.run(node_);
    if (!offer(sink, event)) return false;
    if (!event.run.is_fragment()) statistics.links += event.run.length();
    if (!in_place) node_ = fragments_.after(fragment, node_);
  }
  return true;
}

template <class Index>
bool Merge<Index>::spill(const Sink& sink, Fragment<Index>& fragment, Incidence incidence,
                         Statistics& statistics) {
  Event event{};
  event.incidence = incidence;
  event.number = next_fragment_;
  if (stage_ == Stage::begin) {
    event.kind = Event::Kind::fragment;
    if (!offer(sink, event)) return false;
    node_ = fragments_.first(fragment);
    stage_ = Stage::runs;
  }
  if (stage_ == Stage::runs) {
    if (!deliver_runs(sink, fragment, statistics)) return false;
    stage_ = Stage::end;
  }
  event.kind = Event::Kind::fragment_end;
  if (!offer(sink, event)) return false;
  stage_ = Stage::begin;
  fragments_.give_nodes(fragment);
  fragment.tail = Run::fragment(next_fragment_);
  next_fragment_ = next_fragment_ < Run::max_fragment ? next_fragment_ + 1 : 0;
  ++statistics.spills;
  return true;
}

// The fewer runs are available, the shorter a fragment may be to be spilled: down to any that has
// nodes at all, and then what the last cell took from the pool goes back to it, as it is in the
// fragments that the cell has lengthened.
template <class Index>
bool Merge<Index>::should_spill(const Fragment<Index>& fragment) const {
  if (fragment.last == none) return false;
  if (stage_ != Stage::begin) return true;  // it is the one under way
  const uint32_t available = fragments_.available();
  if (available < 2 * CellReserve::runs) return true;
  if (available >= runs_kept_) return false;
  return fragments_.is_longer(fragment, available / (fragments_.capacity() / 128 + 1));
}

template <class Index>
bool Merge<Index>::spill_touched(const Sink& sink, Statistics& statistics) {
  for (; touched_edges_ > 0; --touched_edges_) {
    const Touched& touched = touched_edge_[touched_edges_ - 1];
    Fragment<Index>& fragment = edges_[touched.index];
    if (should_spill(fragment) && !spill(sink, fragment, touched.incidence, statistics))
      return false;
  }
  for (; touched_rings_ > 0; --touched_rings_) {
    const Touched& touched = touched_ring_[touched_rings_ - 1];
    Fragment<Index>& fragment = regions_.ring(touched.index);
    if (should_spill(fragment) && !spill(sink, fragment, touched.incidence, statistics))
      return false;
  }
  return true;
}

template class Merge<uint16_t>;
template class Merge<uint32_t>;

}  // namespace discmc
