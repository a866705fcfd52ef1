#include <discmc/compiler.hpp>
#include <discmc/host/corners.hpp>

namespace discmc::trace {

namespace {

using Slots = Corners::Slots;
using Lists = Corners::Chains::Lists;

CornerSlot corner(Slots& slots, uint32_t index) {
  return CornerSlot(slots[index]);
}

// The seats of queues, counted through all slots.
uint32_t* seats(Slots& slots) {
  return reinterpret_cast<uint32_t*>(&slots[0]);
}

/// The queues in which begins wait; in the others tails do.
struct BeginQueues {
  bool has[queue_count];
};

void note_ray(BeginQueues& queues, Way way) {
  if (way.is_ahead()) queues.has[way.queue_in()] = true;
}

BeginQueues begin_queues() {
  constexpr uint8_t faces[] = {straight_way, downward_way, upward_way};
  BeginQueues queues{};
  for (const AxisTable& axis : sector_table.axis)
    for (const auto& ways : axis.way) {
      for (const uint8_t face : faces) note_ray(queues, ways[face]);
      for (const auto& of_lower : sector_table.edges)
        for (const uint8_t both : of_lower) note_ray(queues, ways[both >> 4]);
    }
  return queues;
}

/// The voxels before this one have been visited.
struct Front {
  int32_t x, y, z;

  bool has_passed(const Vertex& v) const {
    const int32_t by[] = {(v.z >> 1) - z, (v.y >> 1) - y, (v.x >> 1) - x};
    return (by[0] != 0 ? by[0] : by[1] != 0 ? by[1] : by[2]) < 0;
  }
};

bool is_centroid(const Vertex& v) {
  return (v.x & v.y & v.z & 1) != 0;
}

using Add = void(Slots&, uint32_t&, const Lists::Entry&);

// Adds a straight side to a list, in as many runs as it takes.
void add_runs(Slots& slots, uint32_t& list, Direction direction, uint32_t length, Add& add) {
  while (length > 0) {
    const uint32_t taken = length < longest_short_run ? length : longest_short_run;
    Lists::Entry entry;
    entry.run = short_run(direction, taken);
    add(slots, list, entry);
    length -= taken;
  }
}
// The side from a corner to the next.
void add_side(Slots& slots, uint32_t& list, CornerCode from, CornerCode to, Add& add) {
  add_runs(slots, list, discmc::direction_of(from.incidence(), from.onwards()),
           links_between(from, to), add);
}

/// Makes fragments of slots out of lists of corners, which it gives back.
class HandOver {
 public:
  HandOver(Corners::Chains& chains, const Front& front)
      : chains_(chains), slots_(chains.slots()), front_(front) {}

  /// A begin that waits at a corner: hands it over with all up to the origin of the arm to the
  /// tail, which stays behind and names it, unless the fragment ends there, at a seam.
  void hand_over_begin(uint8_t queue, uint32_t at) {
    uint32_t list = no_slot;
    const CornerCode first = corner(slots_, at).code();
    const uint32_t begin = add_end(queue, first, first.came(), opposite_link(first.came()), list);
    uint32_t origin = at;
    while (!corner(slots_, origin).code().is_origin()) origin = corner(slots_, origin).next();
    const uint32_t last = corner(slots_, origin).mate();
    append_sides(at, last, list);
    if (corner(slots_, last).code().ends_at_seam()) {
      slots_.give(last);
      return chains_.connect(begin, loose_end<uint32_t>(), list);
    }
    slots_[begin].end.last = list;
    corner(slots_, last).set_next(begin);
    corner(slots_, last).set_mate(no_slot);
  }

  /// A tail that waits at a corner: hands it over with the arm to it, and with all from the seam on
  /// where the fragment begins there.
  void hand_over_tail(uint8_t queue, uint32_t at) {
    uint32_t list = no_slot;
    CornerCode code = corner(slots_, at).code();
    if (code.begins_at_seam() && !front_.has_passed(code.vertex())) {
      slots_.give(at);
      return chains_.push_lost(queue);
    }
    const uint32_t tail = add_end(queue, code, code.onwards(), code.onwards(), list);
    while (!code.is_origin()) {
      const uint32_t before = corner(slots_, at).next();
      const CornerCode code_before = corner(slots_, before).code();
      add_side(slots_, list, code_before, code, Lists::prepend);
      slots_.give(at);
      at = before;
      code = code_before;
    }
    const uint32_t first = corner(slots_, at).mate();
    uint32_t begin = corner(slots_, at).next(), list_before = no_slot;
    if (first == no_slot) {
      list_before = slots_[begin].end.last;
    } else {
      const CornerCode seam = corner(slots_, first).code();
      begin = loose_end<uint32_t>(discmc::direction_of(seam.incidence(), seam.onwards()));
      append_sides(first, at, list_before);
    }
    slots_.give(at);
    chains_.connect(begin, tail, Lists::concatenate(slots_, list_before, list));
  }

 private:
  // Appends the sides between two corners to a list, and gives back the corners but the last.
  void append_sides(uint32_t at, uint32_t last, uint32_t& list) {
    while (at != last) {
      const uint32_t next = corner(slots_, at).next();
      append_side(slots_, list, corner(slots_, at).code(), corner(slots_, next).code());
      slots_.give(at);
      at = next;
    }
  }
  // An end that waits, on a side by a link. What has been passed of the side already, ahead of the
  // corner, goes into the list: the rest is short.
  uint32_t add_end(uint8_t queue, CornerCode at, Link side, Link ahead, uint32_t& list) {
    Vertex vertex = at.vertex();
    const Direction direction = discmc::direction_of(at.incidence(), side);
    const Vertex step = link_vector(ahead);
    // A chain that comes may turn at the centroid on the way: see corner_passes().
    const uint32_t passed =
        side != ahead && is_centroid(vertex + step) ? 0 : links_passed(vertex, step);
    add_runs(slots_, list, direction, passed, Lists::append);
    move(vertex, ahead, passed);
    const uint32_t end = slots_.take();
    slots_[end].end.side = Side(direction, place_of(vertex));
    slots_[end].end.mate = end;  // until it has one
    chains_.push(queue, end);
    return end;
  }
  // How many links an end has surely passed beyond a corner. From a centroid there may be one alone
  // that leads back a little, to a vertex ahead.
  uint32_t links_passed(const Vertex& corner, const Vertex& step) const {
    const auto passed = [](int32_t coordinate, int32_t by, int32_t voxel) {
      const int32_t links = (2 * voxel - 2 - coordinate) / by;
      return by > 0 && links > 0 ? static_cast<uint32_t>(links) : 0;
    };
    if (step.z != 0) return passed(corner.z, step.z, front_.z);
    if (step.y != 0) return passed(corner.y, step.y, front_.y);
    return passed(corner.x, step.x, front_.x);
  }

  Corners::Chains& chains_;
  Slots& slots_;
  Front front_;
};

}  // namespace

void append_side(Slots& slots, uint32_t& list, CornerCode from, CornerCode to) {
  add_side(slots, list, from, to, Lists::append);
}

// ---- room ----

bool Corners::start(Slots& slots) {
  constexpr uint32_t block = min_seats / seats_per_slot;
  corners_ = free_corners_ = free_places_ = 0;
  free_ = no_slot;
  joins_ = next_join_ = 0;
  if (slots.available() < min_slots) return false;
  for (uint32_t queue = 0; queue <= inner_queue; ++queue) {
    count_[exit_of(queue)] = count_[entry_of(queue)] = 0;
    set_ring(slots, queue, min_seats - 1, slots.take_fresh(block));
  }
  return true;
}

// Gives a queue a ring of seats in a block of slots. They are written, as all slots in use are.
void Corners::set_ring(Slots& slots, uint32_t queue, uint32_t mask, uint32_t block) {
  const uint32_t first = block * seats_per_slot;
  for (uint32_t i = 0; i <= mask; ++i) seats(slots)[first + i] = 0;
  mask_[exit_of(queue)] = mask_[entry_of(queue)] = mask;
  first_[exit_of(queue)] = first_[entry_of(queue)] = first;
}

bool Corners::find_room(Slots& slots, uint32_t corners, uint32_t edges) {
  const uint32_t more = corners > free_corners_ ? corners - free_corners_ : 0;
  if (slots.available() < more + reserve_of(corners_ + more)) return false;
  add_corners(slots, more);
  return edges <= free_places_ || find_places(slots);
}

void Corners::add_corners(Slots& slots, uint32_t count) {
  corners_ += count;
  free_corners_ += count;
  for (; count > 0; --count) {
    const uint32_t index = slots.take();
    CornerSlot made = corner(slots, index);
    made.set_next(free_);
    made.set_mate(no_slot);
    made.set_code(CornerCode(0));
    free_ = index;
  }
}

// Makes room in the queues: each has a free place at least for each one that is taken.
bool Corners::find_places(Slots& slots) {
  free_places_ = UINT32_MAX;
  for (uint32_t queue = 0; queue <= inner_queue; ++queue) {
    const uint32_t mask = mask_[entry_of(queue)];
    if (waiting(queue) > mask / 2 && !grow(slots, queue)) return false;
    const uint32_t free = mask_[entry_of(queue)] + 1 - waiting(queue);
    if (free < free_places_) free_places_ = free;
  }
  return true;
}

// Makes a queue twice as long.
DISCMC_NOINLINE bool Corners::grow(Slots& slots, uint32_t queue) {
  const uint32_t old_mask = mask_[entry_of(queue)], old_first = first_[entry_of(queue)];
  const uint32_t mask = 2 * old_mask + 1;
  const uint32_t old_block = (old_mask + 1) / seats_per_slot;
  const bool has_room = slots.available() >= reserve_of(corners_) + 2 * old_block;
  const uint32_t block = has_room ? slots.take_fresh(2 * old_block) : no_slot;
  if (block == no_slot) return false;
  set_ring(slots, queue, mask, block);
  uint32_t* const seat = seats(slots);
  for (uint32_t i = count_[exit_of(queue)]; i != count_[entry_of(queue)]; ++i)
    seat[first_[entry_of(queue)] + (i & mask)] = seat[old_first + (i & old_mask)];
  for (uint32_t i = 0; i < old_block; ++i) slots.give(old_first / seats_per_slot + i);
  return true;
}

// ---- chains ----

void Corners::take(Slots& slots, const LearntPasses& passes) {
  Slot<uint32_t, NoNormal>* const slot = &slots[0];
  uint32_t* const seat = seats(slots);
  const NumberedPasses& numbered = passes.numbered();
  uint32_t free = free_;
  uint32_t joins = 0;
  uint32_t taken = passes.count();
  for (const FoundPass found : passes) {
    const CornerPass& pass = numbered[found];
    uint32_t& in_seat = seat[first_[pass.in] + (count_[pass.in]++ & mask_[pass.in])];
    uint32_t& out_seat = seat[first_[pass.out] + (count_[pass.out]++ & mask_[pass.out])];
    const uint32_t from = in_seat, to = out_seat;
    const uint32_t before = is_entry(pass.in) ? to : from;
    join_[joins] = {free, to};
    joins += pass.joins;
    CornerSlot corner(slot[free]);
    const uint32_t next_free = corner.next();
    // Where there is no corner none is made: what goes on is what was there before.
    const auto if_straight = static_cast<uint32_t>(int32_t{pass.if_straight});
    const uint32_t next_change = (before ^ next_free) & if_straight;
    const uint32_t seat_change = (before ^ free) & if_straight;
    corner.set_next(before ^ next_change);
    corner.set_mate(free);
    corner.set_code(CornerCode(found + pass.corner));
    in_seat = out_seat = free ^ seat_change;
    free = next_free ^ next_change ^ seat_change;
    taken += if_straight;
  }
  free_ = free;
  free_corners_ -= taken;
  free_places_ -= passes.edges();
  joins_ = joins;
}

void Corners::cut_at_seam(Slots& slots, const Pass& pass, const Vertex& vertex) {
  const auto corner_at = [&](const Vertex& at, Link incoming, Link onwards) {
    return CornerCode(CornerCode::position(at) |
                      CornerCode::sides(pass.incidence, incoming, onwards, true));
  };
  if (pass.in >= first_rising_queue)
    add_at_seam(slots, pass.in, pass.comes_from_ahead,
                corner_at(vertex, pass.incoming, CornerCode::beyond_seam));
  if (pass.out >= first_rising_queue)
    add_at_seam(slots, pass.out, pass.goes_ahead(),
                corner_at(Chains::next_vertex(pass, vertex), CornerCode::beyond_seam, pass.second));
}

// Adds an origin that waits for what comes, or meets what has waited.
void Corners::add_at_seam(Slots& slots, uint8_t queue, bool waits, CornerCode code) {
  if (free_corners_ == 0) add_corners(slots, 1);
  --free_corners_;
  const uint32_t index = free_;
  CornerSlot made = corner(slots, index);
  free_ = made.next();
  made.set_mate(index);
  made.set_code(code);
  const Port port = waits ? entry_of(queue) : exit_of(queue);
  uint32_t& seat = seats(slots)[first_[port] + (count_[port]++ & mask_[port])];
  if (waits) {
    seat = index;
    --free_places_;
    return;
  }
  made.set_next(code.ends_at_seam() ? seat : index);
  join_[joins_++] = {index, code.ends_at_seam() ? index : seat};
}

uint32_t Corners::close_chain(Slots& slots) {
  while (next_join_ != joins_) {
    const Join join = join_[next_join_++];
    // The arm to the tail that came, turned round.
    uint32_t from = corner(slots, join.corner).next();
    for (uint32_t after = join.corner;;) {
      CornerSlot turned = corner(slots, from);
      const uint32_t before = turned.next();
      turned.set_next(after);
      if (turned.code().is_origin()) break;
      after = from;
      from = before;
    }
    // The arm from the begin that waited.
    corner(slots, join.corner).set_next(join.to);
    uint32_t to = join.to;
    while (!corner(slots, to).code().is_origin()) to = corner(slots, to).next();
    const uint32_t begin = corner(slots, from).mate();
    if (begin == to) return join.corner;
    const uint32_t tail = corner(slots, to).mate();
    corner(slots, begin).set_mate(tail);
    corner(slots, tail).set_mate(begin);
    if (corner(slots, begin).code().begins_at_seam() && corner(slots, tail).code().ends_at_seam()) {
      corner(slots, tail).set_next(begin);
      return begin;
    }
  }
  joins_ = next_join_ = 0;
  return no_slot;
}

void Corners::give(Slots& slots, uint32_t chain, uint32_t count) {
  const uint32_t second = corner(slots, chain).next();
  corner(slots, chain).set_next(free_);
  free_ = second;
  free_corners_ += count;
}

// ---- handing over ----

void Corners::hand_over(Chains& chains, const SweptRow& row, uint32_t word) {
  Slots& slots = chains.slots();
  const BeginQueues begins = begin_queues();
  HandOver fragments(chains, {static_cast<int32_t>(column_of(word, 1)), row.y, row.z});
  const auto hand_over_from = [&](uint8_t queue) {
    for (uint32_t i = count_[exit_of(queue)]; i != count_[entry_of(queue)]; ++i) {
      const uint32_t at = seats(slots)[first_[exit_of(queue)] + (i & mask_[exit_of(queue)])];
      if (begins.has[queue])
        fragments.hand_over_begin(queue, at);
      else
        fragments.hand_over_tail(queue, at);
    }
  };
  // The begins first: a tail finds that of its fragment at the origin.
  for (uint8_t queue = 0; queue < queue_count; ++queue)
    if (begins.has[queue]) hand_over_from(queue);
  for (uint8_t queue = 0; queue < queue_count; ++queue)
    if (!begins.has[queue]) hand_over_from(queue);
  give_all(slots);
}

// Gives back what no fragment uses.
void Corners::give_all(Slots& slots) {
  while (free_ != no_slot) {
    const uint32_t next = corner(slots, free_).next();
    slots.give(free_);
    free_ = next;
  }
  for (uint32_t queue = 0; queue <= inner_queue; ++queue) {
    const uint32_t block = first_[exit_of(queue)] / seats_per_slot;
    for (uint32_t i = 0; i <= mask_[exit_of(queue)] / seats_per_slot; ++i) slots.give(block + i);
  }
}

}  // namespace discmc::trace
