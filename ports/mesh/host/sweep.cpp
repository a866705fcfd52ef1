#include "sweep.hpp"

namespace discmc::host {

namespace {

using detail::trace::SlabRole;

// Whether the ring turns to the right at its last vertex.
bool is_hole(const OneRingRegion& region) {
  return 2 * region.left_turn(0) > direction_count(region.incidence());
}

}  // namespace

void Sweep::clear() {
  FirmwareSweep::clear();
  edges_.clear();
  is_due_ = false;
  has_ends_from_below_ = false;
  handed_word_ = 0;
  keeps_nodes_ = chains_.start(slots());
}

bool Sweep::sweep(const detail::trace::SweptRow& row, const BitIntake& intake, const Sink& sink,
                  Statistics& statistics) {
  while (keeps_nodes_) {
    if (is_due_ && !deliver(sink, statistics)) return false;
    if (edges_.is_empty() && !ensure_room(row)) {
      if (!chains_.has_complete()) hand_over(row);
    } else if (edges_.collect(row)) {
      process_edges(statistics);
    } else {
      return true;
    }
  }
  return sweep_as_firmware(row, intake, sink, statistics);
}

bool Sweep::flush(const Sink& sink, Statistics& statistics) {
  if (!keeps_nodes_) return true;
  if (is_due_ && !deliver(sink, statistics)) return false;
  process_edges(statistics);
  return deliver(sink, statistics);
}

bool Sweep::deliver_remaining_holes(const Sink& sink, Statistics& statistics) {
  if (keeps_nodes_) {
    if (!flush(sink, statistics)) return false;
    chains_.find_complete(slots());
    if (!deliver(sink, statistics)) return false;
  }
  return FirmwareSweep::deliver_remaining_holes(sink, statistics);
}

uint32_t Sweep::left_triangle_parts() const {
  return counts_.triangle_parts();
}

void Sweep::process_edges(Statistics& statistics) {
  is_due_ = true;
  found_.find(edges_, counts_);
  counts_.add_to(statistics);
  chains_.process(slots(), found_, edges_.count());
  edges_.discard_all();
}

// ---- handing over ----

// Returns false if complete fragments must be delivered first, or if no room can be made.
bool Sweep::ensure_room(const detail::trace::SweptRow& row) {
  const bool may_stay = row.z < CornerCode::max_slices;
  if (may_stay && chains_.has_room(slots())) return true;
  chains_.find_complete(slots());
  is_due_ = chains_.has_complete();
  return !is_due_ && may_stay && chains_.compact(slots());
}

// Below a slab, all chains belong to another slab; the firmware's sweep counts their ends as lost.
void Sweep::hand_over(const detail::trace::SweptRow& row) {
  keeps_nodes_ = false;
  if (row.role == SlabRole::below_slab) return chains_.release_all(slots());
  has_ends_from_below_ = true;
  handed_word_ = edges_.word();
  passes_.continue_from(handed_word_);
  chains_.hand_over(fragments_, row, handed_word_);
}

bool Sweep::sweep_as_firmware(const detail::trace::SweptRow& row, const BitIntake& intake,
                              const Sink& sink, Statistics& statistics) {
  detail::trace::SweptRow rest = row;
  if (has_ends_from_below_ && row.is_own()) rest.role = SlabRole::inside;
  if (row.role == SlabRole::above_slab && handed_word_ > 0) {
    // The row above a slab is swept twice; both sweeps begin at handed_word_.
    fragments_.set_below_is_lost(false);
    if (!chains_are_ended_) {
      if (!process_passes(row, intake, sink, statistics)) return false;
      chains_are_ended_ = true;
      passes_.continue_from(handed_word_);
    }
    if (!process_passes(row, intake, sink, statistics)) return false;
    chains_are_ended_ = false;
  } else if (!FirmwareSweep::sweep(rest, intake, sink, statistics)) {
    return false;
  }
  handed_word_ = 0;
  return true;
}

// ---- delivery ----

// Delivers all rings and complete fragments. Returns false if the sink is busy.
bool Sweep::deliver(const Sink& sink, Statistics& statistics) {
  if (!delivery_.deliver(fragments_, sink, statistics)) return false;
  while (chains_.find_ring(slots()))
    if (!deliver_ring(sink, statistics)) return false;
  while (chains_.has_complete()) {
    chains_.set_outgoing_fragment(fragments_);
    if (!delivery_.deliver(fragments_, sink, statistics)) return false;
  }
  is_due_ = false;
  return true;
}

// Whether holes wait on the plane of a ring.
bool Sweep::may_have_holes(const OneRingRegion& region) {
  const auto& holes = delivery_.holes();
  return holes.count() > 0 && holes.has_any(slots(), region.incidence(), region.start());
}

// Returns the found ring as a region. It begins at its last vertex, as in Delivery; this vertex is
// a corner.
DISCMC_ALWAYS_INLINE OneRingRegion Sweep::found_region(uint64_t& links) {
  uint64_t* const corner = chains_.corners();
  const uint32_t count = chains_.corner_count();
  DISCMC_LIMIT(count <= Chains::max_corners + 2);
  uint64_t last = 0;
  uint32_t first = 0;
  for (uint32_t i = 0; i < count; ++i) {
    corner[count + i] = corner[i];
    links += links_between(CornerCode(corner[i]), CornerCode(corner[i + 1]));
    // Without a branch.
    const uint64_t is_later = 0 - uint64_t{corner[i] > last};
    last ^= (last ^ corner[i]) & is_later;
    first ^= (first ^ i) & static_cast<uint32_t>(is_later);
  }
  return {corner + first, count};
}

// Delivers the found ring.
bool Sweep::deliver_ring(const Sink& sink, Statistics& statistics) {
  uint64_t links = 0;
  const OneRingRegion region = found_region(links);
  if (region.corner_count() == 0 || is_hole(region) || may_have_holes(region)) {
    chains_.set_outgoing_ring(fragments_);
    return delivery_.deliver(fragments_, sink, statistics);
  }
  if ((receiver_.accept == nullptr ||
       receiver_.accept(receiver_.context, region) != SinkResult::accepted) &&
      !send_events(region, sink, statistics))
    return false;
  statistics.links += links;
  ++statistics.rings;
  ++statistics.regions;
  return true;
}

// If the sink is busy, the ordinary delivery continues.
bool Sweep::send_events(const OneRingRegion& region, const Sink& sink, Statistics& statistics) {
  uint32_t sent = discmc::send_events(region, [&](const Event& event) {
    return sink.accept(sink.context, event) == SinkResult::accepted;
  });
  if (sent == region.corner_count() + 3) return true;
  chains_.set_outgoing_ring(fragments_);
  delivery_.begin(fragments_);
  for (; sent > 0; --sent) delivery_.select_next(fragments_, statistics);
  return false;
}

}  // namespace discmc::host
