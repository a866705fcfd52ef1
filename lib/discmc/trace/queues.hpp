// Queues of waiting ends, first in, first out: one queue per kind of link and direction of the
// chain.
//
// An end without a slot is lost. Its position in the queue stays, so that the other ends keep their
// partners. The queue counts lost ends in one of three encodings:
//
//   only lost ends wait           in the Queue: top bit of `head` set, the count in the other bits
//                                 of `head` and in `tail` (32-bit indices: in `tail` alone)
//   lost ends beside others       in a slot of the queue whose `mate` is no_slot: the count is in
//                                 `runs` and in the bits of `side` (32-bit indices: in `runs`
//                                 alone)
//   the queue ends with an end    none, but a slot of the pool is reserved for a count behind it
#ifndef DISCMC_TRACE_QUEUES_HPP
#define DISCMC_TRACE_QUEUES_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/base/pool.hpp>
#include <discmc/capacities.hpp>
#include <discmc/trace/sector_table.hpp>
#include <discmc/trace/slots.hpp>

namespace discmc::detail::trace {

/// The first and the last slot of a queue. An empty queue has no_slot as its head.
template <class Index>
struct Queue {
  Index head, tail;
};

template <class Index, class Normal>
class Queues {
 public:
  using Slots = Pool<Slot<Index, Normal>, Index>;

  void start(Queue<Index>* queues) { queues_ = queues; }
  void clear() {
    for (int i = 0; i < queue_count; ++i) queues_[i].head = no_slot;
    lose_from(queue_count);
  }

  /// Whether a lost end is the last entry of a queue.
  bool is_last_lost(const Slots& slots, uint8_t number) const {
    const Queue<Index>& queue = queues_[number];
    if (queue.head == no_slot) return false;
    return is_count(queue) || slots[queue.tail].end.mate == no_slot;
  }

  /// Appends an end. Limit: slots.available() >= 2.
  void push(Slots& slots, uint8_t number, Index end) {
    DISCMC_LIMIT(slots.available() >= 2);
    Queue<Index>& queue = queues_[number];
    slots[end].linked.next = no_slot;
    if (queue.head == no_slot) {
      queue.head = end;
      slots.reserve();
    } else if (is_count(queue)) {
      push_behind_lost(slots, queue, end);
    } else {
      Slot<Index, Normal>& last = slots[queue.tail];
      if (last.end.mate == no_slot) slots.reserve();
      last.linked.next = end;
    }
    queue.tail = end;
  }

  /// Appends a lost end.
  void push_lost(Slots& slots, uint8_t number) {
    Queue<Index>& queue = queues_[number];
    if (queue.head == no_slot) return set_count(queue, 1);
    if (is_count(queue)) return set_count(queue, count_of(queue) + 1);
    End<Index, Normal>& last = slots[queue.tail].end;
    if (last.mate == no_slot) return set_lost(last, lost_of(last) + 1);
    slots.unreserve();
    const Index lost = new_count(slots, 1);
    last.next = lost;
    queue.tail = lost;
  }

  /// Treats all ends of this queue and of the queues after it as lost.
  void lose_from(int number) { first_lost_ = static_cast<uint8_t>(number); }

  /// Removes the first entry: an end, or no_slot for a lost end.
  Index pop(Slots& slots, uint8_t number) {
    if (number >= first_lost_) return no_slot;
    Queue<Index>& queue = queues_[number];
    const Index head = queue.head;
    if (is_count(queue) || slots[head].end.mate == no_slot) return pop_lost(slots, queue);
    queue.head = slots[head].linked.next;
    if (queue.head == no_slot) slots.unreserve();
    return head;
  }

 private:
  static constexpr Index top = static_cast<Index>(Index{1} << (8 * sizeof(Index) - 1));
  static constexpr bool is_narrow = sizeof(Index) == sizeof(uint16_t);
  static_assert(detail::sizing::max_slots<Index> < top &&
                    detail::sizing::max_slots<Index> < loose_end<Index>(),
                "indices of slots are neither counts nor loose ends");
  static_assert(uint64_t{Limits::max_extent + 1} * (Limits::max_extent + 1) < uint64_t{1} << 31,
                "31 bits count lost ends: a queue has one at most for each voxel of a slice");
  static_assert(queue_count <= UINT8_MAX, "a byte has the number of a queue");

  static bool is_count(const Queue<Index>& queue) { return (queue.head & top) != 0; }
  static uint32_t count_of(const Queue<Index>& queue) {
    return is_narrow ? uint32_t{queue.head & (top - 1U)} << 16 | queue.tail : queue.tail;
  }
  DISCMC_NOINLINE static void set_count(Queue<Index>& queue, uint32_t count) {
    queue.head =
        count == 0 ? Index{no_slot} : static_cast<Index>(top | (is_narrow ? count >> 16 : 0));
    queue.tail = static_cast<Index>(count);
  }

  static uint32_t lost_of(const End<Index, Normal>& end) {
    return is_narrow ? uint32_t{end.runs} | static_cast<uint32_t>(end.side.bits()) << 16 : end.runs;
  }
  static void set_lost(End<Index, Normal>& end, uint32_t count) {
    end.runs = static_cast<Index>(count);
    if (is_narrow) end.side.set_bits(static_cast<uint16_t>(count >> 16));
  }
  DISCMC_ALWAYS_INLINE Index new_count(Slots& slots, uint32_t count) {
    const Index lost = slots.allocate();
    slots[lost].end.next = no_slot;
    slots[lost].end.mate = no_slot;
    set_lost(slots[lost].end, count);
    return lost;
  }
  DISCMC_ALWAYS_INLINE void push_behind_lost(Slots& slots, Queue<Index>& queue, Index end) {
    const Index lost = new_count(slots, count_of(queue));
    slots[lost].linked.next = end;
    queue.head = lost;
    slots.reserve();
  }
  DISCMC_ALWAYS_INLINE Index pop_lost(Slots& slots, Queue<Index>& queue) {
    if (is_count(queue)) {
      set_count(queue, count_of(queue) - 1);
      return no_slot;
    }
    const Index lost = queue.head;
    End<Index, Normal>& end = slots[lost].end;
    set_lost(end, lost_of(end) - 1);
    if (lost_of(end) == 0) {
      queue.head = end.next;
      slots.release(lost);
    }
    return no_slot;
  }

  Queue<Index>* queues_ = nullptr;
  uint8_t first_lost_ = 0;
};

}  // namespace discmc::detail::trace

#endif
