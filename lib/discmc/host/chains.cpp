#include <discmc/host/chains.hpp>

namespace discmc::host {

using Slots = Chains::Slots;

// ---- room ----

bool Chains::start(Slots& slots) {
  free_places_ = complete_ = joins_ = next_join_ = 0;
  if (slots.available() < min_slots) return false;
  const uint32_t first = slots.take_fresh(seat_slots) * seats_per_slot;
  for (uint32_t queue = 0; queue < queue_codes; ++queue) {
    seats_[queue] = {first + queue * min_seats, min_seats};
    of_in_[queue] = of_out_[queue] = seats_[queue].first;
  }
  block_slots_ = min_nodes;
  block_ = slots.take_fresh(block_slots_);
  bottom_ = top_ = 1;
  end_ = block_slots_ / 2;
  // All slots in use are written: a checkpoint has them.
  for (uint32_t i = 0; i < queue_codes * min_seats; ++i) seats(slots)[first + i] = 0;
  for (uint32_t i = 0; i < block_slots_; ++i) nodes(slots)[i] = {};
  return true;
}

bool Chains::make_room(Slots& slots) {
  if (free_places_ < Edges::max_edges && !find_places(slots)) return false;
  if (has_room(slots)) return true;
  copy_open(slots);
  const uint32_t open = top_ - bottom_;
  if (open > block_slots_ / 8 && grow(slots)) return true;
  // So that copying now and then is little work for each pass.
  top_ += open;
  const bool is_enough = has_room(slots);
  top_ -= open;
  return is_enough;
}

// Gives the nodes twice as many slots.
bool Chains::grow(Slots& slots) {
  const uint32_t more = 2 * block_slots_;
  if (slots.available() < reserve() + more + slots_a_node * block_slots_) return false;
  const uint32_t block = slots.take_fresh(more);
  if (block == no_slot) return false;
  const Node* const old = nodes(slots);
  const uint32_t old_block = block_;
  block_ = block;
  Node* const node = nodes(slots);
  for (uint32_t i = 0; i < more; ++i) node[i] = {};
  for (uint32_t i = bottom_; i < top_; ++i) node[i] = old[i];
  for (uint32_t i = 0; i < block_slots_; ++i) slots.give(old_block + i);
  block_slots_ = more;
  end_ = more / 2;
  return true;
}

// So that a fragment is known to end there, and in which seat it waits.
void Chains::mark_tails(Slots& slots) {
  for (uint32_t queue = 0; queue < seam_tails; ++queue)
    for (uint32_t i = front(queue); i != back(queue); ++i)
      nodes(slots)[seats(slots)[i]].next = Node::waiting_tail + i;
}

// Copies the nodes of open fragments, each behind the one before it in the chain.
void Chains::copy_open(Slots& slots) {
  Node* const node = nodes(slots);
  uint32_t* const seat = seats(slots);
  mark_tails(slots);
  back(seam_tails) = front(seam_tails) = seats_[seam_tails].first;
  const bool is_lower = end_ < block_slots_;
  const uint32_t bottom = is_lower ? end_ : 1;
  uint32_t top = bottom;
  complete_ = 0;
  for (uint32_t queue = tail_queues; queue < queue_codes; ++queue)
    for (uint32_t i = front(queue); i != back(queue); ++i) {
      uint32_t at = seat[i];
      const uint32_t first = top;
      seat[i] = first;
      do {
        node[top] = node[at];
        node[top].next = top + 1;
        if (!node[top].goes_straight()) ++top;
        at = node[at].next;
      } while (at < Node::waiting_tail);
      if (top == first) ++top;
      node[top - 1].next = Node::no_node;
      if (at != Node::no_node) {
        seat[at - Node::waiting_tail] = top - 1;
      } else if (queue == seam_begins) {
        const uint32_t other = front(queue) + complete_++;
        seat[i] = seat[other];
        seat[other] = first;
      }
    }
  bottom_ = bottom;
  top_ = top;
  end_ = is_lower ? block_slots_ : block_slots_ / 2;
}

// Makes room in the queues.
bool Chains::find_places(Slots& slots) {
  const auto free_places = [&](uint32_t queue) { return seats_[queue].end() - back(queue); };
  const auto find_least = [&] {
    free_places_ = UINT32_MAX;
    for (uint32_t queue = 0; queue < queue_codes; ++queue)
      if (free_places(queue) < free_places_) free_places_ = free_places(queue);
  };
  find_least();
  if (free_places_ >= Edges::max_edges) return true;
  back(seam_tails) = front(seam_tails);
  for (uint32_t queue = 0; queue < queue_codes; ++queue)
    if (free_places(queue) < seats_[queue].count / 2 && !make_places(slots, queue)) return false;
  find_least();
  return true;
}

// Moves what waits in a queue to its first seats, or to twice as many elsewhere.
bool Chains::make_places(Slots& slots, uint32_t queue) {
  const Seats old = seats_[queue];
  const uint32_t waiting = back(queue) - front(queue);
  uint32_t* const seat = seats(slots);
  uint32_t first = old.first;
  if (waiting > old.count / 2) {
    const uint32_t block_slots = 2 * old.count / seats_per_slot;
    const bool may_take = slots.available() >= reserve() + block_slots;
    const uint32_t block = may_take ? slots.take_fresh(block_slots) : uint32_t{no_slot};
    if (block == no_slot) return false;
    first = block * seats_per_slot;
    seats_[queue] = {first, 2 * old.count};
    for (uint32_t i = waiting; i < 2 * old.count; ++i) seat[first + i] = 0;
  }
  for (uint32_t i = 0; i < waiting; ++i) seat[first + i] = seat[front(queue) + i];
  front(queue) = first;
  back(queue) = first + waiting;
  if (first != old.first)
    for (uint32_t i = 0; i < old.count / seats_per_slot; ++i)
      slots.give(old.first / seats_per_slot + i);
  return true;
}

void Chains::give_all(Slots& slots) {
  for (uint32_t i = 0; i < block_slots_; ++i) slots.give(block_ + i);
  for (const Seats& seats : seats_)
    for (uint32_t i = 0; i < seats.count / seats_per_slot; ++i)
      slots.give(seats.first / seats_per_slot + i);
}

// ---- passes ----

void Chains::take(Slots& slots, const FoundPasses& passes, uint32_t edges) {
  Node* const node = nodes(slots);
  uint32_t* const seat = seats(slots);
  uint32_t top = top_;
  uint32_t joins = 0;
  passes.for_each([&](uint64_t voxel, PassWord pass) {
    const uint32_t in = in_of(pass), out = out_of(pass);
    uint32_t& in_seat = seat[of_in_[in]++];
    uint32_t& out_seat = seat[of_out_[out]++];
    const uint32_t before = in_seat, after = out_seat;
    // All bits, or none.
    const uint32_t comes_from_ahead = 0 - uint32_t{has_begins(in)};
    const uint32_t goes_ahead = 0 - uint32_t{!has_begins(out)};
    const uint32_t has_no_corner = 0 - uint32_t{ray_ends.incoming[in] == ray_ends.straight[out]};
    const uint32_t is_straight = has_no_corner & (comes_from_ahead ^ goes_ahead);
    const uint32_t goes_on = before ^ ((before ^ after) & comes_from_ahead);
    in_seat = out_seat = top ^ ((goes_on ^ top) & is_straight);
    node[top].set_voxel(voxel);
    node[top].next = after | goes_ahead;
    node[top].pass = pass;
    node[before & ~(comes_from_ahead | is_straight)].next = top;
    join_[joins] = top;
    joins += 1 + (comes_from_ahead | goes_ahead);
    top += 1 + is_straight;
  });
  top_ = top;
  joins_ = joins;
  free_places_ -= edges;
}

bool Chains::find_ring(Slots& slots) {
  const Node* const node = nodes(slots);
  while (next_join_ != joins_) {
    const uint32_t join = join_[next_join_++];
    uint32_t at = join;
    uint64_t* corner = corner_;
    uint32_t steps = short_walk;
    do {
      corner = node[at].add_corners(corner);
      at = node[at].next;
    } while (at < join && --steps != 0);
    if (at > join && (at == Node::no_node || node[at].pass != Node::shortcut)) continue;
    ring_ = join;
    if (at != join) {
      if (!comes_back(slots, at)) continue;
      for (at = join, corner = corner_; corner < corner_ + max_corners;) {
        corner = node[at].add_corners(corner);
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

// Whether a chain comes back to the ring's join, on which there is a long way from there to a node.
DISCMC_NOINLINE bool Chains::comes_back(Slots& slots, uint32_t at) {
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
  node[top_].set_voxel(last);
  node[top_].next = node[ring_].next;
  node[top_].pass = Node::shortcut;
  node[ring_].next = top_++;
  return false;
}

}  // namespace discmc::host
