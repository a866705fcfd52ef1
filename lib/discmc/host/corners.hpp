// Fragments as lists of corners: how a host keeps them while it has memory to spare.
//
// A pass writes one corner at most and reads nothing but the queues; what waits there is the number
// of a corner: the last one of a chain that goes on, or the first one of a chain that comes. Every
// corner names the one that was there before it, up to the origin, where the fragment began to be
// traced. So a fragment has two arms, to its tail and to its begin, each known from its end. Where
// chains meet the two arms there are walked once, to turn one of them round: what lies between
// their origins is then a list in the chain's direction. The origins at the ends of that list name
// each other: they are mates.
//
// At the seam of a slab a chain that comes from beyond begins, and one that goes there ends, at an
// origin of which only one end waits. A fragment between two of these is complete, as a ring is.
//
// Corners and queues lie in the pool of slots: a checkpoint has them, and those of no more use
// are slots again.
#ifndef DISCMC_HOST_CORNERS_HPP
#define DISCMC_HOST_CORNERS_HPP

#include <discmc/compiler.hpp>
#include <discmc/host/learnt_passes.hpp>
#include <discmc/trace/fragments.hpp>

namespace discmc::trace {

/// A corner, in the bytes of a slot. What it names is said above.
class CornerSlot {
 public:
  using Slot = trace::Slot<uint32_t, NoNormal>;

  explicit CornerSlot(Slot& slot) : bytes_(reinterpret_cast<uint8_t*>(&slot)) {}

  uint32_t next() const { return get<uint32_t>(0); }
  void set_next(uint32_t next) { set(0, next); }
  uint32_t mate() const { return get<uint32_t>(4); }
  void set_mate(uint32_t mate) { set(4, mate); }
  CornerCode code() const { return CornerCode(get<uint64_t>(8)); }
  void set_code(CornerCode code) { set(8, code.bits()); }

 private:
  static_assert(sizeof(Slot) == 16, "a corner fits a slot");

  template <class Value>
  Value get(size_t at) const {
    Value value;
    copy_bytes(&value, bytes_ + at, sizeof value);
    return value;
  }
  template <class Value>
  void set(size_t at, Value value) {
    copy_bytes(bytes_ + at, &value, sizeof value);
  }

  uint8_t* bytes_;
};

class Corners {
 public:
  using Chains = Fragments<uint32_t, NoNormal>;
  using Slots = Chains::Slots;

  // Of the ring of a queue.
  static constexpr uint32_t seats_per_slot = sizeof(Slot<uint32_t, NoNormal>) / sizeof(uint32_t);
  static constexpr uint32_t min_seats = 512;
  static_assert(min_seats / 2 >= LearntPasses::max_edges, "a queue that is half full has room");
  /// Twice what queues take.
  static constexpr uint32_t min_slots = 2 * (inner_queue + 1) * min_seats / seats_per_slot;

  /// Begins with slots that have just been cleared. False when they are fewer than the least.
  bool start(Slots& slots);

  /// Makes room for so many corners, made at so many edges. False when too many slots would be in
  /// use: then hand_over().
  bool make_room(Slots& slots, uint32_t corners, uint32_t edges) {
    const bool has_room = slots.available() >= reserve_of(corners_) && corners <= free_corners_ &&
                          edges <= free_places_;
    return has_room || find_room(slots, corners, edges);
  }

  /// Takes passes in. Limit: there is room, and all rings have been closed.
  void take(Slots& slots, const LearntPasses& passes);

  /// The most corners that cut_at_seam() makes of the passes at a vertex.
  static constexpr uint32_t max_cut = 2 * PassList::most;
  /// Cuts a chain off at a seam, at a vertex of the slice beyond it: there it ends, and at the next
  /// vertex it begins. Below a slab, the end waits for what comes; above, it is met. Limit: below,
  /// as take(); above, all slots may be used that are set aside, and there is no hand_over().
  void cut_at_seam(Slots& slots, const Pass& pass, const Vertex& vertex);

  /// Joins the chains that have met, in the order in which they did, until a ring is closed, or a
  /// fragment has come to seams at both its ends: a corner of it, the first one of a fragment, or
  /// no_slot when there are no more. Its corners name one another in its direction; the last one
  /// of a fragment names the first.
  uint32_t close_chain(Slots& slots);

  /// Gives the corners of a closed chain back, of which one is named. count: how many they are.
  void give(Slots& slots, uint32_t chain, uint32_t count);

  /// Hands all fragments over, when a sweep has come to a place.
  void hand_over(Chains& chains, const SweptRow& row, uint32_t word);

 private:
  // For handing over, slots are set aside: a corner that waits at both its ends becomes two ends
  // and, as both its sides may be long, up to six slots of runs.
  static constexpr uint32_t slots_a_corner = 10;
  static constexpr uint32_t max_joins = LearntPasses::max_edges * PassList::most;

  /// Chains that have met: the one that comes names the corner before; `to` is the one that goes.
  struct Join {
    uint32_t corner, to;
  };

  static uint32_t reserve_of(uint32_t corners) { return slots_a_corner * corners; }
  bool find_room(Slots& slots, uint32_t corners, uint32_t edges);
  void add_corners(Slots& slots, uint32_t count);
  void add_at_seam(Slots& slots, uint8_t queue, bool waits, CornerCode code);
  bool find_places(Slots& slots);
  bool grow(Slots& slots, uint32_t queue);
  void give_all(Slots& slots);
  void set_ring(Slots& slots, uint32_t queue, uint32_t mask, uint32_t block);
  uint32_t waiting(uint32_t queue) const {
    return count_[entry_of(queue)] - count_[exit_of(queue)];
  }

  uint32_t corners_ = 0;     // all of them
  uint32_t free_ = no_slot;  // those to be used next, in a list
  uint32_t free_corners_ = 0;
  uint32_t free_places_ = 0;  // no queue has fewer
  uint32_t joins_ = 0;
  uint32_t next_join_ = 0;
  // Queues are rings of seats. By port: how many have been put in or taken out there; by either
  // port of a queue: the seats of its ring less one, and the first of them.
  uint32_t count_[ports] = {};
  uint32_t mask_[ports] = {};
  uint32_t first_[ports] = {};
  Join join_[max_joins + 1] = {};
};

/// Appends the straight side between two corners to a list of runs.
void append_side(Corners::Slots& slots, uint32_t& list, CornerCode from, CornerCode to);

}  // namespace discmc::trace

#endif
