#include "sweep.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <new>

namespace discmc::host {

namespace {

using Lists = Sweep::Fragments::Lists;

// Whether the ring turns to the right at its last vertex.
bool is_hole(const OneRingRegion& region) {
  return 2 * region.left_turn(0) > direction_count(region.incidence());
}

// Turns the corners of a ring so that the first one is its last vertex, at which regions begin;
// this vertex is a corner. Repeats all corners behind the last one. Returns the first corner, and
// adds the number of links to `links`.
const std::uint64_t* turned_to_last_vertex(std::uint64_t* corners, std::uint32_t count,
                                           std::uint64_t& links) {
  std::uint64_t last = 0;
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    corners[count + i] = corners[i];
    links += links_between(CornerCode(corners[i]), CornerCode(corners[i + 1]));
    // Without a branch.
    const std::uint64_t is_later = 0 - std::uint64_t{corners[i] > last};
    last ^= (last ^ corners[i]) & is_later;
    first ^= (first ^ i) & static_cast<std::uint32_t>(is_later);
  }
  return corners + first;
}

}  // namespace

void Sweep::start(Arena& arena, const Capacities&) {
  using detail::trace::Queue;
  auto* const queues = arena.allocate<Queue<std::uint32_t>>(detail::trace::queue_count);
  auto* const holes = arena.allocate<std::uint32_t>(detail::sizing::hole_lists<std::uint32_t>);
  if (!slots_) slots_.reset(new Slot[max_slots_]);
  fragments_.start(slots_.get(), max_slots_, queues);
  delivery_.start(holes, UINT32_MAX);
  receiver_ = {};
}

void Sweep::clear() {
  fragments_.clear();
  delivery_.clear();
  edges_.clear();
  chains_.clear();
  counts_ = {};
  is_due_ = has_base_ = false;
  std::fill(std::begin(hole_marks_), std::end(hole_marks_), std::uint8_t{0});
}

bool Sweep::sweep(const detail::trace::SweptRow& row, const detail::trace::BitIntake&,
                  const Sink& sink, Statistics& statistics) {
  if (!has_base_) base_ = row.z;
  has_base_ = true;
  for (;;) {
    if (is_due_ && !deliver(sink, statistics)) return false;
    if (edges_.is_empty() && chains_.is_full()) {
      // Complete fragments leave before nodes are copied.
      chains_.find_complete();
      is_due_ = chains_.has_complete();
      if (!is_due_) chains_.copy_open();
    } else if (edges_.collect(row, row.z - base_)) {
      process_edges(statistics);
    } else {
      return true;
    }
  }
}

bool Sweep::flush(const Sink& sink, Statistics& statistics) {
  process_edges(statistics);
  return deliver(sink, statistics);
}

bool Sweep::deliver_remaining_holes(const Sink& sink, Statistics& statistics) {
  if (!flush(sink, statistics)) return false;
  chains_.find_complete();
  return deliver(sink, statistics) &&
         delivery_.deliver_remaining_holes(fragments_, sink, statistics);
}

void Sweep::process_edges(Statistics& statistics) {
  if (edges_.is_empty()) return;
  is_due_ = true;
  found_.find(edges_, counts_);
  counts_.add_to(statistics);
  chains_.process(found_, edges_.count());
  edges_.discard_all();
}

// ---- delivery ----

// Delivers all rings and complete fragments. Returns false if the sink is busy.
bool Sweep::deliver(const Sink& sink, Statistics& statistics) {
  if (!delivery_.deliver(fragments_, sink, statistics)) return false;
  while (chains_.find_ring())
    if (!deliver_ring(sink, statistics)) return false;
  while (chains_.has_complete()) {
    chains_.find_fragment();
    set_outgoing(Outgoing::Kind::fragment, chains_.corners(), chains_.corner_count());
    if (!delivery_.deliver(fragments_, sink, statistics)) return false;
  }
  is_due_ = false;
  return true;
}

// Delivers the found ring.
bool Sweep::deliver_ring(const Sink& sink, Statistics& statistics) {
  std::uint64_t links = 0;
  const std::uint32_t count = chains_.corner_count();
  const std::uint64_t* const corners = turned_to_last_vertex(chains_.corners(), count, links);
  OneRingRegion region(corners, count);
  region.move({0, 0, 2 * base_});
  const bool waits = is_hole(region);
  if (waits) hole_mark(region) = 1;
  if (waits || may_have_holes(region)) {
    set_outgoing(Outgoing::Kind::ring, corners, count);
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

// Returns the mark of a ring's plane: 1 if a hole has waited there. Planes may share a mark, so
// may_have_holes() then searches. Most rings need no search.
std::uint8_t& Sweep::hole_mark(const OneRingRegion& region) {
  const auto plane = static_cast<std::uint32_t>(plane_offset(region.incidence(), region.start()));
  const std::uint32_t spread = (plane * incidence_codes + region.incidence()) * 0x9E3779B1U;
  return hole_marks_[spread / (1U << 20)];
}

// Whether holes wait in the box around a ring.
bool Sweep::may_have_holes(const OneRingRegion& region) {
  const auto& holes = delivery_.holes();
  if (holes.count() == 0 || hole_mark(region) == 0) return false;
  ProjectedPoint low = projected(region.incidence(), region.start()), high = low;
  for (std::uint32_t i = 1; i < region.corner_count(); ++i)
    widen(low, high, projected(region.incidence(), region.corner(i)));
  return holes.has_any(fragments_.slots(), region.incidence(), region.start(), low, high);
}

// If the sink is busy, the ordinary delivery continues.
bool Sweep::send_events(const OneRingRegion& region, const Sink& sink, Statistics& statistics) {
  std::uint32_t sent = discmc::send_events(region, [&](const Event& event) {
    return sink.accept(sink.context, event) == SinkResult::accepted;
  });
  if (sent == region.corner_count() + 3) return true;
  set_outgoing(Outgoing::Kind::ring, region.codes(), region.corner_count());
  delivery_.begin(fragments_);
  for (; sent > 0; --sent) delivery_.select_next(fragments_, statistics);
  return false;
}

// ---- slots ----

// Makes a chain outgoing, as runs between its corners. A ring has its first corner once more behind
// the others.
void Sweep::set_outgoing(Outgoing::Kind kind, const std::uint64_t* corners, std::uint32_t count) {
  const CornerCode start(corners[0]);
  const std::uint32_t sides = kind == Outgoing::Kind::ring ? count : count - 1;
  constexpr std::uint32_t max_length = detail::trace::max_short_length;
  std::uint64_t runs = 0;
  for (std::uint32_t i = 0; i < sides; ++i)
    runs += links_between(CornerCode(corners[i]), CornerCode(corners[i + 1])) / max_length + 1;
  constexpr std::uint64_t runs_of_slot = Lists::entries;
  ensure_slots(runs / runs_of_slot + 1);
  std::uint32_t list = no_slot;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const CornerCode from(corners[i]);
    const Direction direction = direction_of(start.incidence(), from.onwards());
    for (std::uint32_t length = links_between(from, CornerCode(corners[i + 1])); length > 0;) {
      const std::uint32_t part = std::min(length, max_length);
      Lists::Entry entry;
      entry.run = detail::trace::short_run(direction, part);
      Lists::append(fragments_.slots(), list, entry);
      length -= part;
    }
  }
  const Vertex base{0, 0, 2 * base_};
  fragments_.set_outgoing(kind, start.incidence(), list, start.vertex() + base);
  fragments_.outgoing().incoming = direction_of(start.incidence(), start.onwards());
}

// Ensures free slots for a chain and one hole, beyond the spare slots of Delivery.
void Sweep::ensure_slots(std::uint64_t count) {
  Fragments::Slots& slots = fragments_.slots();
  constexpr std::uint64_t spare =
      minimum_capacities().slots +
      detail::trace::Holes<std::uint32_t, detail::trace::NoNormal>::slots_each;
  const std::uint64_t needed = slots.in_use() + count + spare;
  if (needed <= max_slots_) return;
  if (needed > detail::sizing::max_slots<std::uint32_t> / 2) throw std::bad_alloc();
  const auto larger_count = 2 * static_cast<std::uint32_t>(needed);
  std::unique_ptr<Slot[]> larger(new Slot[larger_count]);
  slots.unpoison_free();
  std::memcpy(static_cast<void*>(larger.get()), slots_.get(), slots.peak() * sizeof(Slot));
  slots_ = std::move(larger);
  max_slots_ = larger_count;
  slots.move_to(slots_.get(), max_slots_);
}

}  // namespace discmc::host
