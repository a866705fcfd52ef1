// Converts chains to slots: rings and fragments that are sent event by event, and all open chains
// when the firmware's sweep continues.
#include <algorithm>

#include "chains.hpp"

namespace discmc::host {

using Slots = Chains::Slots;

namespace {

using Fragments = Chains::Fragments;
using Lists = Fragments::Lists;
using Outgoing = detail::trace::Outgoing<uint32_t>;

bool is_centroid(const Vertex& v) {
  return (v.x & v.y & 1) != 0;
}

// Voxels before this one have been visited.
struct SweepPosition {
  int32_t x, y, z;

  bool has_passed(const Vertex& v) const {
    return precedes({v.x >> 1, v.y >> 1, v.z >> 1}, {x, y, z});
  }
  // Returns a lower bound of the links that the sweep has passed; 0 if the side leads back.
  uint32_t links_passed(const Vertex& corner, const Vertex& step) const {
    const auto passed = [](int32_t coordinate, int32_t by, int32_t voxel) {
      const int32_t links = (2 * voxel - 2 - coordinate) / by;
      return by > 0 && links > 0 ? static_cast<uint32_t>(links) : 0;
    };
    if (step.z != 0) return passed(corner.z, step.z, z);
    if (step.y != 0) return passed(corner.y, step.y, y);
    return passed(corner.x, step.x, x);
  }
};

// Returns the corner at which a fragment begins at a seam: the end of the last link beyond it.
CornerCode seam_corner(const Node& node) {
  const CornerCode behind(node.corner_behind());
  Vertex at = behind.vertex();
  if (is_centroid(at)) translate(at, behind.onwards(), 1);
  return CornerCode(CornerCode::position(at) |
                    uint64_t{behind.incidence()} << CornerCode::incidence_shift |
                    CornerCode::links(CornerCode::beyond_seam, behind.onwards()));
}

// Makes the list of a chain's sides from its corners.
class Sides {
 public:
  Sides(Slots& slots, CornerCode first) : slots_(slots), last_(first) {}

  Direction direction(Link link) const { return direction_of(last_.incidence(), link); }
  void add_side(Direction direction, uint32_t length) {
    while (length > 0) {
      const uint32_t max_length = detail::trace::max_short_length;
      const uint32_t part = length < max_length ? length : max_length;
      Lists::Entry entry;
      entry.run = detail::trace::short_run(direction, part);
      Lists::append(slots_, list_, entry);
      length -= part;
    }
  }
  void add(CornerCode corner) {
    add_side(direction(last_.onwards()), links_between(last_, corner));
    last_ = corner;
  }
  void add(const Node& node) {
    uint64_t corners[3];
    const uint64_t* const end = node.append_corners(corners);
    for (const uint64_t* corner = corners; corner != end; ++corner) add(CornerCode(*corner));
  }

  CornerCode last() const { return last_; }
  uint32_t list() const { return list_; }

 private:
  Slots& slots_;
  CornerCode last_;
  uint32_t list_ = no_slot;
};

// Makes the waiting end at a corner. side: the link of the end's direction. ahead: the link away
// from the fragment. Links that the sweep has surely passed become a run, so the rest of the side
// is short. may_turn: no link becomes a run, because the chain may turn at the next centroid.
uint32_t new_end(Slots& slots, Sides& sides, CornerCode corner, Link side, Link ahead,
                 bool may_turn, const SweepPosition& position) {
  Vertex vertex = corner.vertex();
  const Vertex step = link_vector(ahead);
  const uint32_t passed = may_turn ? 0 : position.links_passed(vertex, step);
  sides.add_side(sides.direction(side), passed);
  translate(vertex, ahead, passed);
  const uint32_t end = slots.allocate();
  slots[end].end.side = detail::trace::Side(sides.direction(side), detail::trace::place_of(vertex));
  slots[end].end.mate = end;  // until it has one
  return end;
}

}  // namespace

void Chains::set_outgoing_ring(Fragments& fragments) const {
  const Node* const node = nodes(fragments.slots());
  uint32_t first = ring_;
  uint64_t corners[3];
  while (node[first].append_corners(corners) == corners) first = node[first].next;
  const CornerCode start(corners[0]);
  Sides sides(fragments.slots(), start);
  uint32_t at = first;
  do {
    sides.add(node[at]);
    at = node[at].next;
  } while (at != first);
  sides.add(start);
  fragments.set_outgoing(Outgoing::Kind::ring, start.incidence(), sides.list(), start.vertex());
}

// Fragments leave in the order of completion, which is that of their newest nodes. The newest node
// gets the seat of the fragment, and the chain becomes a circle.
void Chains::find_complete(Slots& slots) {
  Node* const node = nodes(slots);
  uint32_t* const seat = seats(slots);
  complete_ = 0;
  for (uint32_t i = front(seam_begins); i != back(seam_begins); ++i) {
    const uint32_t first = seat[i];
    uint32_t last = first, newest = first;
    while (node[last].next != Node::no_node) {
      last = node[last].next;
      if (last > newest && node[last].pass != Node::shortcut) newest = last;
    }
    if (!node[last].ends_at_seam()) continue;
    node[last].next = first;
    uint32_t& other = seat[front(seam_begins) + complete_++];
    seat[i] = other;
    other = newest;
  }
  std::sort(seat + front(seam_begins), seat + front(seam_begins) + complete_);
}

void Chains::set_outgoing_fragment(Fragments& fragments) {
  DISCMC_LIMIT(complete_ > 0);
  --complete_;
  const Node* const node = nodes(fragments.slots());
  uint32_t at = seats(fragments.slots())[front(seam_begins)++];
  while (!node[at].begins_at_seam()) at = node[at].next;
  const CornerCode start = seam_corner(node[at]);
  Sides sides(fragments.slots(), start);
  while (!node[at].ends_at_seam()) {
    at = node[at].next;
    sides.add(node[at]);
  }
  fragments.set_outgoing(Outgoing::Kind::fragment, start.incidence(), sides.list(), start.vertex());
  fragments.outgoing().incoming = sides.direction(start.onwards());
}

void Chains::hand_over(Fragments& fragments, const detail::trace::SweptRow& row, uint32_t word) {
  DISCMC_LIMIT(complete_ == 0);
  Slots& slots = fragments.slots();
  const Node* const node = nodes(slots);
  uint32_t* const seat = seats(slots);
  const SweepPosition position{static_cast<int32_t>(detail::trace::column_of(word, 1)), row.y,
                               row.z};
  mark_tails(slots);
  for (uint32_t queue = first_begins; queue < queue_codes; ++queue)
    for (uint32_t i = front(queue); i != back(queue); ++i) {
      const Node& first_node = node[seat[i]];
      const uint32_t available = slots.available();
      uint32_t nodes_passed = 1;
      const bool begins_at_seam = first_node.begins_at_seam();
      const CornerCode first =
          begins_at_seam ? seam_corner(first_node) : CornerCode(first_node.corner());
      uint32_t at = first_node.next;
      Sides sides(slots, first);
      uint32_t begin = detail::trace::loose_end<uint32_t>(sides.direction(first.onwards()));
      if (!begins_at_seam) {
        const Link came = first.incoming();
        const bool may_turn = queue_traits.turns[queue] != 0;
        begin = new_end(slots, sides, first, came, opposite_link(came), may_turn, position);
        fragments.push(queue_traits.number[queue], begin);
        if (first_node.turns_behind()) sides.add(CornerCode(first_node.corner_behind()));
      } else if (at >= Node::waiting_tail && !position.has_passed(first.vertex())) {
        seat[at - Node::waiting_tail] = no_slot;
        continue;
      }
      for (; at < Node::waiting_tail; at = node[at].next) {
        sides.add(node[at]);
        ++nodes_passed;
      }
      uint32_t tail = detail::trace::loose_end<uint32_t>();
      if (at != Node::no_node) {
        const CornerCode last = sides.last();
        tail = new_end(slots, sides, last, last.onwards(), last.onwards(), false, position);
        seat[at - Node::waiting_tail] = tail;
      }
      fragments.connect(begin, tail, sides.list());
      DISCMC_LIMIT(available - slots.available() <= slots_per_node * nodes_passed);
    }
  for (uint32_t queue = 0; queue < seam_tails; ++queue)
    for (uint32_t i = front(queue); i != back(queue); ++i)
      if (seat[i] == no_slot)
        fragments.push_lost(queue_traits.number[queue]);
      else
        fragments.push(queue_traits.number[queue], seat[i]);
  release_all(slots);
}

}  // namespace discmc::host
