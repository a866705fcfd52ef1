// Lists of runs: circular, named by their last record, three runs a record.
#ifndef DISCMC_TRACE_RUN_LIST_HPP
#define DISCMC_TRACE_RUN_LIST_HPP

#include <discmc/pool.hpp>
#include <discmc/trace/records.hpp>

namespace discmc::trace {

/// What can be done to the lists of a pool. An empty list is no_record.
template <class Index, class Normal>
struct RunLists {
  using Records = Pool<Record<Index, Normal>, Index>;
  using Slot = typename RunRecord<Index, Normal>::Slot;
  static constexpr int slots = RunRecord<Index, Normal>::slots;

  /// Puts a run behind the others, or before them. Cost: a record at most.
  static void append(Records& records, Index& last, const Slot& run) {
    add(records, last, run, slots - 1);
  }
  static void prepend(Records& records, Index& last, const Slot& run) {
    add(records, last, run, 0);
  }

  /// The last run. Limit: not empty.
  static ShortRun last_run(const Records& records, Index last) {
    const Slot* const slot = records[last].runs.slot;
    return slot[2].run != 0 ? slot[2].run : slot[1].run != 0 ? slot[1].run : slot[0].run;
  }

  /// Makes one list of two, which are then void.
  static Index concatenate(Records& records, Index first, Index second) {
    if (first == no_record) return second;
    if (second == no_record) return first;
    const Index head = records[first].linked.next;
    records[first].linked.next = records[second].linked.next;
    records[second].linked.next = head;
    return second;
  }

  /// Gives all records of a list back. Limit: not empty. Cost: a step a record.
  static void give(Records& records, Index last) {
    for (Index index = records[last].linked.next;;) {
      const Index next = records[index].linked.next;
      records.give(index);
      if (index == last) return;
      index = next;
    }
  }

  /// How many records a list has, if not more than `most`, else a larger number.
  /// Cost: at most `most` steps and one.
  static uint32_t records_up_to(const Records& records, Index last, uint32_t most) {
    uint32_t count = 0;
    if (last == no_record) return count;
    Index index = last;
    do {
      index = records[index].linked.next;
      ++count;
    } while (index != last && count <= most);
    return count;
  }

 private:
  // outermost: the slot where a record is full on the side of the run: the last one behind the
  // others, the first one before them.
  static void add(Records& records, Index& last, const Slot& run, int outermost) {
    const bool is_behind = outermost != 0;
    if (last != no_record) {
      Slot* const slot = records[is_behind ? last : records[last].linked.next].runs.slot;
      if (slot[outermost].run == 0) {
        slot[slot[1].run == 0 ? 1 : outermost] = run;
        return;
      }
    }
    const Index index = records.take();
    RunRecord<Index, Normal>& record = records[index].runs;
    for (Slot& slot : record.slot) slot.run = 0;
    record.slot[slots - 1 - outermost] = run;
    // Behind the last is before the first.
    record.next = index;
    if (last != no_record) {
      record.next = records[last].linked.next;
      records[last].linked.next = index;
    }
    if (is_behind || last == no_record) last = index;
  }
};

/// A place in a list, from run to run and round again.
template <class Index, class Normal>
class RunCursor {
 public:
  using Records = Pool<Record<Index, Normal>, Index>;
  using Slot = typename RunRecord<Index, Normal>::Slot;

  RunCursor() = default;
  /// At the first run of a list. Limit: not empty.
  RunCursor(const Records& records, Index last) : place_(first_of(records[last].linked.next)) {
    if (run(records) == 0) advance(records);
  }

  const Slot& slot(const Records& records) const {
    return records[record()].runs.slot[place_ % places];
  }
  ShortRun run(const Records& records) const { return slot(records).run; }
  void advance(const Records& records) {
    do {
      ++place_;
      if (place_ % places == RunLists<Index, Normal>::slots)
        place_ = first_of(records[record()].linked.next);
    } while (run(records) == 0);
  }

  bool operator==(const RunCursor& other) const { return place_ == other.place_; }
  bool operator!=(const RunCursor& other) const { return place_ != other.place_; }

 private:
  static constexpr size_t places = 4;  // of a record: its slots, and one more

  static size_t first_of(Index record) { return size_t{record} * places; }
  Index record() const { return static_cast<Index>(place_ / places); }

  size_t place_ = 0;
};

}  // namespace discmc::trace

#endif
