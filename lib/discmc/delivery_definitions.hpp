// The merge's side towards the sink, between cells: complete regions go out, and fragments early.
//
// Every event is made in one place, settle(), and what comes next is settled when the sink has
// taken it: so a delivery may be suspended before any event.
#ifndef DISCMC_DELIVERY_DEFINITIONS_HPP
#define DISCMC_DELIVERY_DEFINITIONS_HPP

#include <discmc/merge.hpp>

namespace discmc {

template <class Index, class Normals>
bool Merge<Index, Normals>::settle(const Sink& sink, Statistics& statistics) {
  Event event{};
  while (is_delivering_ || begin_delivery()) {
    event.kind = next_event_;
    event.incidence = incidence_;
    if (next_event_ == Event::Kind::ring) {
      const ClosedRing<Index, Normal>& ring = regions_.ring(ring_);
      event.start = regions_.start_of(ring);
      event.hole = ring.hole != 0;
    }
    if (next_event_ == Event::Kind::run) {
      event.run = node_ != no_record ? fragments_.run(node_) : fragment_->tail;
      if constexpr (Normals::hold_samples)
        event.normal =
            node_ != no_record ? fragments_.start_normal(node_) : fragment_->start_normal();
    }
    if (sink.take(sink.context, event) != Answer::taken) return false;
    go_on(event.run, statistics);
  }
  return true;
}

// Complete regions come first: they give runs back.
template <class Index, class Normals>
bool Merge<Index, Normals>::begin_delivery() {
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
  while (touched_count_ > 0 && !is_delivering_) {
    const Touched& touched = touched_[--touched_count_];
    if ((touched.incidence & is_ring) != 0)
      fragment_ = &regions_.ring(touched.index);
    else
      fragment_ = &edges_[touched.index];
    ring_ = no_record;
    incidence_ = touched.incidence & (is_ring - 1);
    next_event_ = Event::Kind::fragment;
    is_delivering_ = should_spill(*fragment_);
  }
  return is_delivering_;
}

// The fewer runs are available, the shorter a fragment may be to be spilled: down to any that has
// nodes at all, and then what the last cell took from the pool goes back to it, as it is in the
// fragments that the cell has lengthened.
template <class Index, class Normals>
bool Merge<Index, Normals>::should_spill(const Fragment<Index, Normal>& fragment) const {
  if (fragment.last == no_record) return false;
  const uint32_t available = fragments_.available();
  if (available < 2 * CellReserve::runs) return true;
  return fragments_.is_longer(fragment, available / (fragments_.capacity() / 128 + 1));
}

// The sink has taken an event: what comes next?
template <class Index, class Normals>
void Merge<Index, Normals>::go_on(Run run, Statistics& statistics) {
  switch (next_event_) {
    case Event::Kind::region:
      next_event_ = Event::Kind::ring;
      break;
    case Event::Kind::ring:
      fragment_ = &regions_.ring(ring_);
      node_ = fragments_.first(*fragment_);
      next_event_ = Event::Kind::run;
      break;
    case Event::Kind::run:
      statistics.links += run.length();
      if (node_ != no_record)
        node_ = fragments_.after(*fragment_, node_);
      else
        end_runs(statistics);
      break;
    case Event::Kind::region_end:
      regions_.remove_first_complete();
      ++statistics.regions;
      is_delivering_ = false;
      break;
    default:
      break;
  }
}

// All runs of a ring or fragment are gone; what held them goes back to the pool.
template <class Index, class Normals>
void Merge<Index, Normals>::end_runs(Statistics& statistics) {
  // A stand-in starts where the first run does, which has a node: see should_spill().
  if (ring_ == no_record)
    fragment_->set_start_normal(fragments_.start_normal(fragments_.first(*fragment_)));
  fragments_.give_nodes(*fragment_);
  if (ring_ == no_record) {
    next_event_ = Event::Kind::fragment_end;
    return;
  }
  ++statistics.rings;
  if (ring_ == last_ring_) {
    next_event_ = Event::Kind::region_end;
  } else {
    next_event_ = Event::Kind::ring;
    --splits_;
  }
  ring_ = regions_.give_ring(ring_);
}

}  // namespace discmc

#endif
