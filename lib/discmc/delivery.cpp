// The merge's side towards the sink, between cells: complete regions go out, and fragments early.
//
// Every event is made in one place, settle(), and what comes next is settled when the sink has
// taken it: so a delivery may be suspended before any event.
#include <discmc/merge.hpp>

namespace discmc {

template <class Index>
bool Merge<Index>::settle(const Sink& sink, Statistics& statistics) {
  Event event{};
  while (is_delivering_ || begin_delivery()) {
    event.kind = next_event_;
    event.incidence = incidence_;
    event.number = next_fragment_;
    if (next_event_ == Event::Kind::ring) {
      const ClosedRing<Index>& ring = regions_.ring(ring_);
      event.start = regions_.start_of(ring);
      event.hole = ring.hole != 0;
    }
    if (next_event_ == Event::Kind::run) {
      event.run = node_ != no_record ? fragments_.run(node_) : fragment_->tail;
    }
    if (sink.take(sink.context, event) != Answer::taken) return false;
    go_on(event.run, statistics);
  }
  return true;
}

// Complete regions come first: they give runs back.
template <class Index>
bool Merge<Index>::begin_delivery() {
  if (regions_.has_complete()) {
    const Index region = regions_.first_complete();
    last_ring_ = regions_.rings_outer_first(region);
    ring_ = regions_.ring(last_ring_).next;
    incidence_ = regions_.incidence(region);
    next_event_ = Event::Kind::region;
    is_delivering_ = true;
    return true;
  }
  if (!runs_are_short()) return false;
  while (touched_edges_ > 0) {
    const Touched& touched = touched_edge_[--touched_edges_];
    if (begin_spill(edges_[touched.index], touched.incidence)) return true;
  }
  while (touched_rings_ > 0) {
    const Touched& touched = touched_ring_[--touched_rings_];
    if (begin_spill(regions_.ring(touched.index), touched.incidence)) return true;
  }
  return false;
}

template <class Index>
bool Merge<Index>::begin_spill(Fragment<Index>& fragment, Incidence incidence) {
  if (!should_spill(fragment)) return false;
  fragment_ = &fragment;
  ring_ = no_record;
  incidence_ = incidence;
  next_event_ = Event::Kind::fragment;
  is_delivering_ = true;
  return true;
}

// The fewer runs are available, the shorter a fragment may be to be spilled: down to any that has
// nodes at all, and then what the last cell took from the pool goes back to it, as it is in the
// fragments that the cell has lengthened.
template <class Index>
bool Merge<Index>::should_spill(const Fragment<Index>& fragment) const {
  if (fragment.last == no_record) return false;
  const uint32_t available = fragments_.available();
  if (available < 2 * CellReserve::runs) return true;
  return fragments_.is_longer(fragment, available / (fragments_.capacity() / 128 + 1));
}

// The sink has taken an event: what comes next?
template <class Index>
void Merge<Index>::go_on(Run run, Statistics& statistics) {
  switch (next_event_) {
    case Event::Kind::region:
      next_event_ = Event::Kind::ring;
      break;
    case Event::Kind::ring:
      fragment_ = &regions_.ring(ring_);
      [[fallthrough]];
    case Event::Kind::fragment:
      node_ = fragments_.first(*fragment_);
      next_event_ = Event::Kind::run;
      break;
    case Event::Kind::run:
      if (!run.is_fragment()) statistics.links += run.length();
      if (node_ != no_record)
        node_ = fragments_.after(*fragment_, node_);
      else
        end_runs();
      break;
    case Event::Kind::region_end: {
      const uint32_t rings = regions_.remove_first_complete();
      splits_ -= rings - 1;
      statistics.rings += rings;
      ++statistics.regions;
      is_delivering_ = false;
      break;
    }
    default:  // fragment_end
      fragment_->tail = Run::fragment(next_fragment_);
      next_fragment_ = next_fragment_ < Run::max_fragment ? next_fragment_ + 1 : 0;
      ++statistics.spills;
      is_delivering_ = false;
  }
}

// All runs of a ring or fragment are gone; what held them goes back to the pool.
template <class Index>
void Merge<Index>::end_runs() {
  fragments_.give_nodes(*fragment_);
  if (ring_ == no_record) {
    next_event_ = Event::Kind::fragment_end;
    return;
  }
  next_event_ = ring_ == last_ring_ ? Event::Kind::region_end : Event::Kind::ring;
  ring_ = regions_.ring(ring_).next;
}

template class Merge<uint16_t>;
template class Merge<uint32_t>;

}  // namespace discmc
