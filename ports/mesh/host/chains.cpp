#include "chains.hpp"

#include <algorithm>
#include <new>

#include <discmc/base/checks.hpp>

namespace discmc::host {

// ---- room ----

namespace {

// Returns a number of nodes or seats. Throws if it would reach those of waiting tails.
std::uint32_t below_tails(std::uint64_t count) {
  if (count >= Node::waiting_tail) throw std::bad_alloc();
  return static_cast<std::uint32_t>(count);
}

}  // namespace

void Chains::clear() {
  std::uint32_t seat = 0;
  for (std::uint32_t queue = 0; queue < queue_codes; ++queue) {
    next_in_seat_[queue] = next_out_seat_[queue] = first_seat_[queue] = seat;
    seat += is_at_seam(queue) ? sizes_.seats_at_seam : sizes_.seats;
    end_seat_[queue] = seat;
  }
  seat_.resize(seat);
  min_free_seats_ = sizes_.seats;
  max_nodes_ = next_max_nodes_ = sizes_.nodes;
  area_.resize(first_node + max_nodes_);
  top_ = first_node;
  join_.resize(FoundPasses::max_passes + 1);
  joins_ = next_join_ = 0;
  complete_.clear();
  next_complete_ = 0;
  corner_.resize(2 * (2 * ChainSizes::max_walk + 1));  // two corners a node, and one is overwritten
}

// Copies the nodes of open fragments to the other area, in the order of each chain.
void Chains::copy_open() {
  DISCMC_LIMIT(next_join_ == joins_ && !has_complete());
  spare_area_.resize(first_node + next_max_nodes_);
  Node* const node = area_.begin();
  std::uint32_t* const seat = seat_.begin();
  // Marks the last node of each fragment with its seat.
  for (std::uint32_t queue = 0; queue < seam_tails; ++queue)
    for (std::uint32_t i = front(queue); i != back(queue); ++i)
      node[seat[i]].next = Node::waiting_tail + i;
  Node* const copy = spare_area_.begin();
  std::uint32_t top = first_node;
  for (std::uint32_t queue = first_begins; queue < queue_codes; ++queue)
    for (std::uint32_t i = front(queue); i != back(queue); ++i) {
      std::uint32_t at = seat[i];
      const std::uint32_t first = seat[i] = top;
      do {
        copy[top] = node[at];
        copy[top].next = top + 1;
        if (top == first || copy[top].has_corner()) ++top;
        at = node[at].next;
      } while (at < Node::waiting_tail);
      copy[top - 1].next = Node::no_node;
      if (at != Node::no_node) seat[at - Node::waiting_tail] = top - 1;
    }
  area_.swap(spare_area_);
  top_ = top;
  max_nodes_ = next_max_nodes_;
  // The next area is twice as large if a third of this one is open, so copying costs each pass
  // amortised constant time. If half is open, this area grows at once.
  const std::uint64_t open = nodes();
  if (3 * open + ChainSizes::max_new > max_nodes_)
    next_max_nodes_ = below_tails(std::uint64_t{2} * max_nodes_);
  if (2 * open + ChainSizes::max_new <= max_nodes_) return;
  area_.resize(first_node + next_max_nodes_);
  max_nodes_ = next_max_nodes_;
}

void Chains::find_min_free_seats() {
  std::uint32_t min_free = UINT32_MAX;
  const auto find = [&min_free](const std::uint32_t* end, const std::uint32_t* back) {
    for (std::uint32_t i = 0; i < queues_each - 1; ++i)
      min_free = std::min(min_free, end[i] - back[i]);
  };
  find(end_seat_, next_out_seat_);
  find(end_seat_ + first_begins, next_in_seat_ + first_begins);
  min_free_seats_ = min_free;
}

// Makes room in the queues.
void Chains::make_seats() {
  find_min_free_seats();
  if (has_seats()) return;
  back(seam_tails) = front(seam_tails);  // nothing reads this queue
  for (std::uint32_t queue = 0; queue < queue_codes; ++queue) {
    const std::uint32_t needed = is_at_seam(queue) ? ChainSizes::max_across : Edges::max_edges;
    // Few nodes wait, and over a quarter of the seats is used up. They move now, so that a later
    // batch has room.
    const bool is_cheap_move =
        free_seats(queue) < seats(queue) / 4 * 3 && waiting(queue) <= seats(queue) / 16;
    if (free_seats(queue) >= needed && !is_cheap_move) continue;
    const bool has_seats_in_front =
        seats(queue) - waiting(queue) >= needed && 2 * waiting(queue) <= seats(queue);
    if (has_seats_in_front)
      move_waiting(queue, first_seat_[queue]);
    else
      grow_queue(queue);
  }
  find_min_free_seats();
  DISCMC_LIMIT(has_seats());
}

// Moves a queue to twice as many seats, behind all others.
void Chains::grow_queue(std::uint32_t queue) {
  const auto first = static_cast<std::uint32_t>(seat_.size());
  const std::uint32_t end = below_tails(seat_.size() + std::uint64_t{2} * seats(queue));
  seat_.resize(end);
  move_waiting(queue, first);
  first_seat_[queue] = first;
  end_seat_[queue] = end;
}

// Moves the waiting nodes of a queue to the seats from `first` on.
void Chains::move_waiting(std::uint32_t queue, std::uint32_t first) {
  const std::uint32_t count = waiting(queue);
  std::copy(&seat_[front(queue)], &seat_[front(queue)] + count, &seat_[first]);
  front(queue) = first;
  back(queue) = first + count;
}

// ---- passes ----

namespace {

// Returns all bits if the number is zero, otherwise none.
DISCMC_ALWAYS_INLINE std::uint32_t all_if_zero(std::uint32_t number) {
  return 0 - static_cast<std::uint32_t>(number == 0);
}

}  // namespace

void Chains::process(const FoundPasses& passes, std::uint32_t edges) {
  DISCMC_LIMIT(edges <= Edges::max_edges && next_join_ == joins_ && !is_full());
  if (!has_seats()) make_seats();
  Node* const node = area_.begin();
  std::uint32_t* const seat = seat_.begin();
  std::uint32_t* const join = join_.begin();
  std::uint32_t top = top_;
  std::uint32_t joins = 0;
  passes.for_each([&](const std::uint64_t& voxel, PassWord pass) {
    const std::size_t in = in_of(pass), out = out_of(pass);
    const std::uint32_t in_seat = next_in_seat_[in]++, out_seat = next_out_seat_[out]++;
    DISCMC_LIMIT(in_seat < end_seat_[in] && out_seat < end_seat_[out]);
    DISCMC_LIMIT(top < first_node + max_nodes_ && joins < FoundPasses::max_passes);
    const std::uint32_t before = seat[in_seat], after = seat[out_seat];
    // All bits or none, and conditional moves: no branch depends on the surface.
    const std::uint32_t comes_from_ahead = queue_traits.comes_from_ahead[in];
    const std::uint32_t goes_ahead = queue_traits.goes_ahead[out];
    const std::uint32_t difference = queue_traits.straight_in[in] ^ queue_traits.straight_out[out];
    const std::uint32_t is_straight = all_if_zero(difference);
    const std::uint32_t continued = comes_from_ahead != 0 ? after : before;
    seat[in_seat] = seat[out_seat] = difference == 0 ? continued : top;
    node[top].voxel = voxel;
    node[top].next = after | goes_ahead;
    node[top].pass = pass;
    // The node before, if there is one, leads to the new one. If the chain is straight here, all
    // bits are set, that is Node::no_node: the node before stays the last, and `top` does not move.
    node[before & ~comes_from_ahead].next = top | is_straight;
    join[joins] = top;
    joins += 1 + (comes_from_ahead | goes_ahead);
    top += 1 + is_straight;
  });
  top_ = top;
  joins_ = joins;
  next_join_ = 0;
  min_free_seats_ -= edges;
}

// ---- rings ----

bool Chains::find_ring() {
  const Node* const node = area_.begin();
  while (next_join_ != joins_) {
    const std::uint32_t join = join_[next_join_++];
    std::uint32_t at = join;
    std::uint64_t* corner = corner_.begin();
    std::uint32_t steps = sizes_.short_walk;
    do {
      corner = node[at].append_corners(corner);
      at = node[at].next;
    } while (at < join && --steps != 0);
    corner_count_ = static_cast<std::uint32_t>(corner - corner_.begin());
    if (at == join) return true;
    // A newer node: the chain is open. Only a newer shortcut may lead back.
    if (at > join && (at == Node::no_node || node[at].pass != Node::shortcut)) continue;
    if (!leads_to(join, at)) continue;
    corner_count_ = 0;
    list_corners(join, join);
    return true;
  }
  return false;
}

// Whether the chain returns to a join. at: the node at which the short walk stopped. If the chain
// does not return, adds a shortcut to the last node reached.
DISCMC_NOINLINE bool Chains::leads_to(std::uint32_t join, std::uint32_t at) {
  Node* const node = area_.begin();
  std::uint32_t last = at;
  while (at != join) {
    if (at == Node::no_node) break;
    if (node[at].pass == Node::shortcut) {
      last = static_cast<std::uint32_t>(node[at].voxel);
    } else {
      if (at > join) break;
      last = at;
    }
    at = node[last].next;
  }
  if (at == join) return true;
  DISCMC_LIMIT(nodes() < max_nodes_);
  node[top_] = {last, node[join].next, Node::shortcut};
  node[join].next = top_++;
  return false;
}

// Lists further corners of a chain, from one node to the node before `end`.
void Chains::list_corners(std::uint32_t first, std::uint32_t end) {
  std::size_t count = corner_count_;
  std::uint32_t at = first;
  do {
    // A node has two corners at most.
    if (2 * (count + 2) > corner_.size())
      corner_.resize(below_tails(std::uint64_t{2} * corner_.size()));
    const Node& node = area_[at];
    count = static_cast<std::size_t>(node.append_corners(&corner_[count]) - corner_.begin());
    at = node.next;
  } while (at != end);
  corner_count_ = static_cast<std::uint32_t>(count);
}

// ---- fragments between seams ----

namespace {

bool is_centroid(const Vertex& v) {
  return (v.x & v.y & 1) != 0;
}

// Returns the corner at which a fragment begins at a seam: the end of the last link beyond it.
CornerCode seam_corner(const Node& node) {
  const CornerCode behind(node.corner_behind());
  Vertex at = behind.vertex();
  if (is_centroid(at)) translate(at, behind.onwards(), 1);
  return CornerCode(CornerCode::position(at) |
                    uint64_t{behind.incidence()} << CornerCode::incidence_shift |
                    CornerCode::links(CornerCode::beyond_seam, behind.onwards()));
}

}  // namespace

// Fragments leave in the order of completion, which is that of their newest nodes.
void Chains::find_complete() {
  const Node* const node = area_.begin();
  complete_.clear();
  next_complete_ = 0;
  std::uint32_t kept = front(seam_begins);
  for (std::uint32_t i = kept; i != back(seam_begins); ++i) {
    const std::uint32_t first = seat_[i];
    std::uint32_t last = first, newest = first;
    while (node[last].next != Node::no_node) {
      last = node[last].next;
      if (node[last].pass != Node::shortcut) newest = std::max(newest, last);
    }
    if (node[last].ends_at_seam())
      complete_.push_back({newest, first});
    else
      seat_[kept++] = first;
  }
  back(seam_begins) = kept;
  std::sort(complete_.begin(), complete_.end(),
            [](const Complete& a, const Complete& b) { return a.newest < b.newest; });
}

void Chains::find_fragment() {
  DISCMC_LIMIT(has_complete());
  const Node& first = area_[complete_[next_complete_++].first];
  corner_[0] = seam_corner(first).bits();
  corner_count_ = 1;
  list_corners(first.next, Node::no_node);
}

}  // namespace discmc::host
