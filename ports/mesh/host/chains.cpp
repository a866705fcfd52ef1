#include "chains.hpp"

namespace discmc::host {

using Slots = Chains::Slots;

// ---- room ----

namespace {

// Calls visit(queue) for each queue of tails, or of begins.
template <class Visit>
void for_each_queue(uint32_t first, Visit visit) {
  for (uint32_t queue = first; queue < first + queues_each; ++queue) visit(queue);
}
template <class Visit>
void for_each_queue(Visit visit) {
  for_each_queue(0, visit);
  for_each_queue(first_begins, visit);
}

}  // namespace

bool Chains::start(Slots& slots) {
  min_free_seats_ = complete_ = joins_ = next_join_ = 0;
  if (slots.available() < capacities_.slots()) return false;
  (void)new_area(slots, 1);
  uint32_t seat = new_area(slots, capacities_.seat_slots()).first * seats_per_slot;
  for_each_queue([&](uint32_t queue) {
    next_in_seat_[queue] = next_out_seat_[queue] = first_seat_[queue] = seat;
    end_seat_[queue] = seat += is_at_seam(queue) ? capacities_.seats_at_seam : capacities_.seats;
  });
  DISCMC_LIMIT(seat == seats_per_slot * (1 + capacities_.seat_slots()));
  area_[0] = new_area(slots, capacities_.nodes);
  area_[1] = {};
  top_ = area_[0].first;
  end_ = top_ + capacities_.nodes;
  return true;
}

// Returns consecutive slots, or none. Writes them, because a checkpoint contains all used slots.
Chains::Area Chains::new_area(Slots& slots, uint32_t count) {
  const uint32_t slot = slots.allocate_fresh(count);
  if (slot == no_slot) return {};
  const uint32_t first = slot - 1;
  uint32_t* const words = seats(slots) + size_t{first} * seats_per_slot;
  for (size_t i = 0; i < size_t{count} * seats_per_slot; ++i) words[i] = 0;
  return {first, count};
}

void Chains::release(Slots& slots, const Area& area) {
  for (uint32_t i = 0; i < area.slots; ++i) slots.release(area.first + 1 + i);
}

bool Chains::compact(Slots& slots) {
  DISCMC_LIMIT(joins_ == 0 && complete_ == 0);
  if (!grow_queues(slots) || !ensure_spare_area(slots, area_[0].slots)) return false;
  copy_open(slots);
  // Doubles the area if a third is open, so copying costs each pass amortised constant time.
  const uint32_t open = top_ - area_[0].first;
  if (3 * open + max_new > area_[0].slots && ensure_spare_area(slots, 2 * area_[0].slots) &&
      !has_room_for(slots, open))
    copy_open(slots);
  return has_room_for(slots, open);
}

// Ensures that the free area has at least `count` slots. Returns false if there is no room.
bool Chains::ensure_spare_area(Slots& slots, uint32_t count) {
  if (area_[1].slots >= count) return true;
  if (slots.available() < reserve() + count) return false;
  const Area larger = new_area(slots, count);
  if (larger.slots == 0) return false;
  release(slots, area_[1]);
  area_[1] = larger;
  return true;
}

// Marks the last node of each fragment with its seat.
void Chains::mark_tails(Slots& slots) {
  for (uint32_t queue = 0; queue < seam_tails; ++queue)
    for (uint32_t i = front(queue); i != back(queue); ++i)
      nodes(slots)[seats(slots)[i]].next = Node::waiting_tail + i;
}

// Copies the nodes of open fragments to the other area, in the order of each chain.
void Chains::copy_open(Slots& slots) {
  Node* const node = nodes(slots);
  uint32_t* const seat = seats(slots);
  mark_tails(slots);
  const Area area = area_[1];
  uint32_t top = area.first;
  for_each_queue(first_begins, [&](uint32_t queue) {
    for (uint32_t i = front(queue); i != back(queue); ++i) {
      uint32_t at = seat[i];
      const uint32_t first = top;
      seat[i] = first;
      do {
        DISCMC_LIMIT(top < area.first + area.slots);
        node[top] = node[at];
        node[top].next = top + 1;
        if (top == first || node[top].has_corner()) ++top;
        at = node[at].next;
      } while (at < Node::waiting_tail);
      node[top - 1].next = Node::no_node;
      if (at != Node::no_node) seat[at - Node::waiting_tail] = top - 1;
    }
  });
  area_[1] = area_[0];
  area_[0] = area;
  top_ = top;
  end_ = area.first + area.slots;
}

// Makes room in the queues. Returns false if a queue still has too little.
bool Chains::grow_queues(Slots& slots) {
  find_min_free_seats();
  if (has_free_seats()) return true;
  back(seam_tails) = front(seam_tails);  // nothing reads this queue
  for_each_queue([&](uint32_t queue) {
    const uint32_t seats = end_seat_[queue] - first_seat_[queue];
    const uint32_t free = free_seats(queue);
    const uint32_t needed = is_at_seam(queue) ? max_across : Edges::max_edges;
    // Few nodes wait, and over a quarter of the seats is used up. They move now, so that a later
    // batch has room.
    const bool is_cheap_move = free < seats / 4 * 3 && back(queue) - front(queue) <= seats / 16;
    if (free < needed || is_cheap_move) grow_queue(slots, queue);
  });
  find_min_free_seats();
  return has_free_seats();
}

void Chains::find_min_free_seats() {
  uint32_t min_free = UINT32_MAX;
  const auto find = [&min_free](const uint32_t* end, const uint32_t* back) {
    for (uint32_t i = 0; i < queues_each - 1; ++i) {
      const uint32_t free = end[i] - back[i];
      min_free = free < min_free ? free : min_free;
    }
  };
  find(end_seat_, next_out_seat_);
  find(end_seat_ + first_begins, next_in_seat_ + first_begins);
  min_free_seats_ = min_free;
}

// Moves the waiting nodes of a queue to its first seats, or to twice as many seats elsewhere if
// there are slots.
void Chains::grow_queue(Slots& slots, uint32_t queue) {
  uint32_t* const seat = seats(slots);
  const uint32_t waiting = back(queue) - front(queue);
  const uint32_t old_first = first_seat_[queue];
  const uint32_t old_slots = (end_seat_[queue] - old_first) / seats_per_slot;
  DISCMC_LIMIT(is_within_seats(queue));
  uint32_t first = old_first;
  if (waiting > old_slots * seats_per_slot / 2) {
    // Beyond the first eight gigabytes the number of a seat would have the bit that marks tails.
    const bool has_slots = slots.available() >= reserve() + 2 * old_slots &&
                           slots.peak() + 2 * old_slots < Node::waiting_tail / seats_per_slot;
    const Area area = has_slots ? new_area(slots, 2 * old_slots) : Area{};
    if (area.slots == 0) return;
    first_seat_[queue] = first = area.first * seats_per_slot;
    end_seat_[queue] = first + area.slots * seats_per_slot;
  }
  for (uint32_t i = 0; i < waiting; ++i) seat[first + i] = seat[front(queue) + i];
  front(queue) = first;
  back(queue) = first + waiting;
  if (first != old_first) release(slots, {old_first / seats_per_slot, old_slots});
}

void Chains::release_all(Slots& slots) {
  for (const Area& area : area_) release(slots, area);
  release(slots, {0, 1});
  for_each_queue([&](uint32_t queue) {
    const uint32_t first = first_seat_[queue] / seats_per_slot;
    release(slots, {first, end_seat_[queue] / seats_per_slot - first});
  });
}

// ---- passes ----

namespace {

// Returns all bits if the number is zero, otherwise none.
DISCMC_ALWAYS_INLINE uint32_t all_if_zero(uint32_t number) {
  return 0 - static_cast<uint32_t>(number == 0);
}

}  // namespace

void Chains::process(Slots& slots, const FoundPasses& passes, uint32_t edges) {
  DISCMC_LIMIT(edges <= Edges::max_edges);
  DISCMC_LIMIT(edges == 0 || is_ready_for_batch(slots));
  Node* const node = nodes(slots);
  uint32_t* const seat = seats(slots);
  uint32_t top = top_;
  uint32_t joins = 0;
  passes.for_each([&](const uint64_t& voxel, PassWord pass) {
    const size_t in = in_of(pass), out = out_of(pass);
    const uint32_t in_seat = next_in_seat_[in]++, out_seat = next_out_seat_[out]++;
    DISCMC_LIMIT(is_within_seats(in_of(pass)) && is_within_seats(out_of(pass)) && top < end_);
    DISCMC_LIMIT(joins < FoundPasses::max_passes);
    const uint32_t before = seat[in_seat], after = seat[out_seat];
    // All bits or none, and conditional moves: no branch depends on the surface.
    const uint32_t comes_from_ahead = queue_traits.comes_from_ahead[in];
    const uint32_t goes_ahead = queue_traits.goes_ahead[out];
    const uint32_t difference = queue_traits.straight_in[in] ^ queue_traits.straight_out[out];
    const uint32_t is_straight = all_if_zero(difference);
    const uint32_t continued = comes_from_ahead != 0 ? after : before;
    seat[in_seat] = seat[out_seat] = difference == 0 ? continued : top;
    node[top].set_voxel(voxel);
    node[top].next = after | goes_ahead;
    node[top].pass = pass;
    // The node before, if there is one, leads to the new one. If the chain is straight here, all
    // bits are set, that is Node::no_node: the node before stays the last, and `top` does not move.
    node[before & ~comes_from_ahead].next = top | is_straight;
    join_[joins] = top;
    joins += 1 + (comes_from_ahead | goes_ahead);
    top += 1 + is_straight;
  });
  top_ = top;
  joins_ = joins;
  min_free_seats_ -= edges;
}

bool Chains::find_ring(Slots& slots) {
  const Node* const node = nodes(slots);
  while (next_join_ != joins_) {
    const uint32_t join = join_[next_join_++];
    uint32_t at = join;
    uint64_t* corner = corner_;
    uint32_t steps = capacities_.short_walk;
    do {
      DISCMC_LIMIT(corner <= corner_ + max_corners);
      corner = node[at].append_corners(corner);
      at = node[at].next;
    } while (at < join && --steps != 0);
    // A newer node: the chain is open. Only a newer shortcut may lead back.
    if (at > join && (at == Node::no_node || node[at].pass != Node::shortcut)) continue;
    ring_ = join;
    if (at != join) {
      if (!follow_to_join(slots, at)) continue;
      for (at = join, corner = corner_; corner < corner_ + capacities_.corners;) {
        corner = node[at].append_corners(corner);
        at = node[at].next;
        if (at == join) break;
      }
      if (at != join) corner = corner_;
    }
    corner_count_ = static_cast<uint32_t>(corner - corner_);
    return true;
  }
  joins_ = next_join_ = 0;
  return false;
}

// Whether the chain returns to the join of ring_. at: the node at which the short walk stopped. If
// the chain does not return, adds a shortcut to the last node reached.
DISCMC_NOINLINE bool Chains::follow_to_join(Slots& slots, uint32_t at) {
  Node* const node = nodes(slots);
  uint32_t last = at;
  while (at != ring_) {
    if (at == Node::no_node) break;
    if (node[at].pass == Node::shortcut) {
      last = static_cast<uint32_t>(node[at].voxel());
    } else {
      if (at > ring_) break;
      last = at;
    }
    at = node[last].next;
  }
  if (at == ring_) return true;
  DISCMC_LIMIT(top_ < end_);
  node[top_].set_voxel(last);
  node[top_].next = node[ring_].next;
  node[top_].pass = Node::shortcut;
  node[ring_].next = top_++;
  return false;
}

}  // namespace discmc::host
