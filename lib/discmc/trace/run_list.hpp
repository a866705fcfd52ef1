// Lists of runs: circular, named by their last slot, three runs per slot.
#ifndef DISCMC_TRACE_RUN_LIST_HPP
#define DISCMC_TRACE_RUN_LIST_HPP

#include <discmc/base/pool.hpp>
#include <discmc/trace/slots.hpp>

namespace discmc::detail::trace {

/// Operations on the run lists of a pool. An empty list is no_slot.
template <class Index, class Normal>
struct RunLists {
  using Slots = Pool<Slot<Index, Normal>, Index>;
  using Entry = typename RunSlot<Index, Normal>::Entry;
  static constexpr int entries = RunSlot<Index, Normal>::entries;

  /// Adds a run at the end of a list, or at its beginning. Cost: at most a slot.
  static void append(Slots& slots, Index& list, const Entry& run) {
    add(slots, list, run, entries - 1);
  }
  static void prepend(Slots& slots, Index& list, const Entry& run) { add(slots, list, run, 0); }

  /// Returns the last run. Limit: not empty.
  static ShortRun last_run(const Slots& slots, Index list) {
    const Entry* const entry = slots[list].runs.entry;
    return entry[2].run != 0 ? entry[2].run : entry[1].run != 0 ? entry[1].run : entry[0].run;
  }

  /// Joins two lists. Both names are then invalid; the result names the joined list.
  static Index concatenate(Slots& slots, Index first, Index second) {
    if (first == no_slot) return second;
    if (second == no_slot) return first;
    const Index head = slots[first].linked.next;
    slots[first].linked.next = slots[second].linked.next;
    slots[second].linked.next = head;
    return second;
  }

  /// Frees all slots of a list. Limit: not empty. Cost: a step per slot.
  static void release(Slots& slots, Index list) {
    for (Index index = slots[list].linked.next;;) {
      const Index next = slots[index].linked.next;
      slots.release(index);
      if (index == list) return;
      index = next;
    }
  }

  /// Returns the number of slots of a list if that is at most `limit`, otherwise a larger number.
  /// Cost: at most `limit` + 1 steps.
  static uint32_t slots_up_to(const Slots& slots, Index list, uint32_t limit) {
    uint32_t count = 0;
    if (list == no_slot) return count;
    Index index = list;
    do {
      index = slots[index].linked.next;
      ++count;
    } while (index != list && count <= limit);
    return count;
  }

 private:
  // outermost: the slot's last entry to append a run, its first entry to prepend one. If that entry
  // is in use, the slot is full on this side.
  static void add(Slots& slots, Index& list, const Entry& run, int outermost) {
    const bool is_behind = outermost != 0;
    if (list != no_slot) {
      Entry* const entry = slots[is_behind ? list : slots[list].linked.next].runs.entry;
      if (entry[outermost].run == 0) {
        entry[entry[1].run == 0 ? 1 : outermost] = run;
        return;
      }
    }
    const Index index = slots.allocate();
    RunSlot<Index, Normal>& slot = slots[index].runs;
    for (Entry& entry : slot.entry) entry.run = 0;
    slot.entry[entries - 1 - outermost] = run;
    // The end of a circular list is also its beginning.
    slot.next = index;
    if (list != no_slot) {
      slot.next = slots[list].linked.next;
      slots[list].linked.next = index;
    }
    if (is_behind || list == no_slot) list = index;
  }
};

/// A position in a list, which continues from the last run to the first.
template <class Index, class Normal>
class RunCursor {
 public:
  using Slots = Pool<Slot<Index, Normal>, Index>;
  using Entry = typename RunSlot<Index, Normal>::Entry;

  RunCursor() = default;
  /// Begins at the first run of a list. Limit: not empty.
  RunCursor(const Slots& slots, Index list) : position_(first_of(slots[list].linked.next)) {
    if (run(slots) == 0) advance(slots);
  }

  const Entry& entry(const Slots& slots) const {
    return slots[slot()].runs.entry[position_ % positions_per_slot];
  }
  DISCMC_ALWAYS_INLINE ShortRun run(const Slots& slots) const { return entry(slots).run; }
  void advance(const Slots& slots) {
    do {
      ++position_;
      if (position_ % positions_per_slot == RunLists<Index, Normal>::entries)
        position_ = first_of(slots[slot()].linked.next);
    } while (run(slots) == 0);
  }

  bool operator==(const RunCursor& other) const { return position_ == other.position_; }
  bool operator!=(const RunCursor& other) const { return position_ != other.position_; }

 private:
  static constexpr size_t positions_per_slot = 4;  // its entries, and one more

  static size_t first_of(Index slot) { return size_t{slot} * positions_per_slot; }
  Index slot() const { return static_cast<Index>(position_ / positions_per_slot); }

  size_t position_ = 0;
};

}  // namespace discmc::detail::trace

#endif
