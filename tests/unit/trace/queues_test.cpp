// A queue keeps the order of ends and lost ends, for any number of lost ends.
#include <discmc/trace/queues.hpp>

#include <discmc/trace/passes.hpp>

#include "test.hpp"

using namespace discmc;

namespace {

constexpr uint8_t number = 77;

template <class Index>
class Ends {
 public:
  static constexpr uint32_t slots = 20;

  Ends() {
    pool_.start(memory_, slots);
    pool_.clear();
    queues_.start(heads_);
    queues_.clear();
  }

  Index push() {
    const Index end = pool_.allocate();
    pool_[end].end.mate = end;
    queues_.push(pool_, number, end);
    return end;
  }
  void lose(uint32_t count) {
    for (; count > 0; --count) queues_.push_lost(pool_, number);
  }
  // Removes the next entry, releases it, and returns it; no_slot for a lost end.
  Index pop() {
    const Index end = queues_.pop(pool_, number);
    if (end != no_slot) pool_.release(end);
    return end;
  }
  // Pops lost ends up to the first other end, at most `most`. Returns their number.
  uint32_t pop_lost(uint32_t most) {
    uint32_t count = 0;
    while (count < most && queues_.pop(pool_, number) == no_slot) ++count;
    return count;
  }
  bool is_last_lost() const { return queues_.is_last_lost(pool_, number); }
  uint32_t in_use() const { return pool_.in_use(); }

 private:
  detail::trace::Slot<Index, detail::trace::NoNormal> memory_[slots];
  detail::trace::Queue<Index> heads_[detail::trace::queue_count];
  Pool<detail::trace::Slot<Index, detail::trace::NoNormal>, Index> pool_;
  detail::trace::Queues<Index, detail::trace::NoNormal> queues_;
};

}  // namespace

TEST_CASE_TEMPLATE("lost ends in a queue keep their positions among other ends", Index, uint16_t,
                   uint32_t) {
  // A count that needs more than two bytes.
  for (const uint32_t many : {1U, 2U, 0xFFFFU, 0x10000U, 0x30001U}) {
    CAPTURE(many);
    Ends<Index> ends;
    CHECK_FALSE(ends.is_last_lost());
    ends.lose(many);
    CHECK(ends.is_last_lost());
    const Index first = ends.push();
    CHECK_FALSE(ends.is_last_lost());
    const Index second = ends.push();
    ends.lose(many);
    CHECK(ends.is_last_lost());
    const Index third = ends.push();
    CHECK(ends.pop_lost(many) == many);
    CHECK(ends.pop() == first);
    CHECK(ends.pop() == second);
    CHECK(ends.pop_lost(many) == many);
    CHECK(ends.pop() == third);
    CHECK(ends.in_use() == 0);
    // A queue with only lost ends.
    ends.push();
    ends.lose(many);
    CHECK(ends.pop() != no_slot);
    CHECK(ends.pop_lost(many) == many);
    CHECK(ends.in_use() == 0);
  }
}

// The room for a batch of edges in every queue depends on this.
TEST_CASE("each queue at a vertex has at most one incoming and one outgoing pass") {
  uint32_t most = 0, recurrences = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_on : {false, true})
      for (uint32_t lines = 0; lines < 1U << 16; ++lines) {
        detail::trace::PassList passes;
        derive_passes(detail::trace::EdgeLines{axis, is_on, lines}, 0, passes);
        most = std::max<uint32_t>(most, passes.count);
        for (uint32_t i = 0; i < passes.count; ++i)
          for (uint32_t j = 0; j < i; ++j)
            recurrences += passes.pass[i].in_queue == passes.pass[j].in_queue ||
                           passes.pass[i].out_queue == passes.pass[j].out_queue;
      }
  CHECK(recurrences == 0);
  CHECK(most == detail::trace::PassList::max_passes);
}
