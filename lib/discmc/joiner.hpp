// The joiner: loose fragments in, regions out.
//
// An extractor that is short of memory sends pieces of boundary rings early, as loose fragments;
// one that scans a slab does so at its seams. The joiner is a sink that stands before another:
//
//   static Joiner joiner;
//   if (joiner.start(memory, sink, InputOrder::sweep) == Status::ok &&
//       decoder.start(make_sink(joiner)) == Status::ok)
//     ...  // push the stream
//   while (joiner.finish() == Status::suspended)
//     ...  // until the sink takes again
//
// A fragment goes on where its last link leads, and no directed link belongs to two chains: so ends
// match by vertex, incidence and direction, in whatever order they come. A chain that ends where it
// starts is a ring. A hole waits for the outer ring around it, on the same plane.
//
// A shortage of memory loses nothing: from then on the joiner passes on what it holds and what it
// gets, and another with more memory can join that. A sink that wants whole regions alone is made
// by make_region_sink().
#ifndef DISCMC_JOINER_HPP
#define DISCMC_JOINER_HPP

#include <discmc/join/region_holes.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Adds the totals of a scan to those of others, such as the slabs of one volume.
void add(Statistics& sum, const Statistics& other);

/// What is known of the order in which events come.
enum class InputOrder : uint8_t {
  /// That of one sweep. A region is delivered as soon as its outer ring closes.
  sweep,
  /// Loose fragments in any order, of one stream or several. Regions joined of them wait for
  /// finish(). Limit: what one stream has between `region` and `region_end`, or `fragment` and
  /// `fragment_end`, comes without events of others between; and a region that is whole already
  /// comes after the loose fragments that its own stream has before it.
  any,
};

/// What becomes of fragments that the joiner cannot join: for want of a partner, or of memory.
enum class Unjoined : uint8_t {
  passed_on,  ///< to the sink, as loose fragments
  left_out,   ///< they are lost, and so are the regions, or holes, that they belong to
};

/// How much a joiner has room for. Limit: at least 1 of each.
struct JoinCapacities {
  static constexpr uint32_t max_fragments = uint32_t{1} << 28;
  static constexpr uint32_t max_runs = UINT32_MAX - 1;

  uint32_t fragments;  ///< chains not closed yet, and rings that wait
  uint32_t runs;       ///< of all of them
};

/// What a joiner has done since its start.
struct JoinReport {
  uint64_t fragments = 0;  ///< that came
  uint64_t invalid = 0;    ///< of them: left out, for an incidence, direction or run that is none
  uint64_t regions = 0;    ///< delivered, their outer rings joined of fragments
  uint64_t rings = 0;      ///< joined of fragments and delivered in any region
  uint64_t unmatched = 0;  ///< chains without a partner and holes without a region, in the end, and
                           ///< fragments whose place was taken: the measure of what was lost
  uint64_t passed = 0;     ///< chains passed on for lack of memory, whole fragments or some joined
};

/// Takes the events of extractors and decoders and gives them to a sink, regions completed and
/// joined. Any events are safe.
///
/// The sink gets everything but loose fragments in the order in which it came. What the report
/// counts as unmatched or passed it gets as loose fragments, unless these are left out. Runs keep
/// their normals. A region is right when all its fragments came, whatever else is lost.
///
/// The sink gets one `finish` event: of several, in any order, the sum, when finish() is called.
/// Its regions, rings and loose fragments are those that were delivered. Layer marks stay true
/// in the order of a sweep alone.
///
/// It is neither copied nor moved: two would write to the same memory.
///
/// Cost: of a fragment, its runs. Of a region, its runs times the holes that wait on its plane.
class Joiner {
 public:
  Joiner() = default;

  /// The bytes that a joiner takes from the caller's memory, and the least.
  static constexpr uint64_t bytes_for(const JoinCapacities& capacities) {
    return join::WaitingChains::bytes_for(capacities.fragments, capacities.runs) +
           Arena::alignment - 1;
  }
  static constexpr uint64_t minimum_bytes() { return bytes_for({1, 1}); }

  /// The default split of a number of bytes: eight runs for every fragment, in 192 bytes.
  static constexpr JoinCapacities default_capacities(uint64_t bytes) {
    // In 32 bits: no 64-bit division on small machines.
    const uint64_t units = bytes < Arena::alignment ? 0 : (bytes - (Arena::alignment - 1)) >> 6;
    const uint32_t affordable = static_cast<uint32_t>(units < UINT32_MAX ? units : UINT32_MAX) / 3;
    if (affordable == 0) return {1, 1};
    const uint32_t fragments =
        affordable < JoinCapacities::max_fragments ? affordable : JoinCapacities::max_fragments;
    return {fragments, 8 * fragments};
  }

  /// Begins anew, with the default split of the memory. memory: Owner: the caller, for as long as
  /// events are taken. Errors: bad_sink, too_little_memory; then nothing has changed.
  [[nodiscard]] Status start(Memory memory, const Sink& sink, InputOrder order,
                             Unjoined unjoined = Unjoined::passed_on);
  /// The same with capacities of one's own. Errors: also bad_capacities.
  [[nodiscard]] Status start(const JoinCapacities& capacities, Memory memory, const Sink& sink,
                             InputOrder order, Unjoined unjoined = Unjoined::passed_on);

  /// Takes an event; SinkResult::not_started before start(), and where the sink says so. What it
  /// completes has been delivered once it is taken.
  SinkResult take(const Event& event);

  /// Tells that no event follows, and delivers what waits; a `finish` event in the order of a sweep
  /// does the same. Status::suspended: the sink said "not now", call again. Errors: not_started;
  /// bad_sink (it said "never"); too_little_memory when memory was short at any time, though all is
  /// done that can be.
  [[nodiscard]] Status finish();

  const JoinReport& report() const { return report_; }
  JoinCapacities capacities() const { return capacities_; }
  /// The most that was held at once.
  JoinCapacities high_water() const { return {chains().high_water(), chains().run_high_water()}; }

 private:
  Joiner(const Joiner&) = default;
  Joiner& operator=(const Joiner&) = default;  // start() makes it as new

  bool accept(const Event& event);
  bool begin_fragment(const Event& event);
  bool add_run(const Event& event);
  bool end_fragment(const Event& event);
  bool end_region(const Event& event);
  bool lose(const Event& event);
  bool take_start(const Event& event);
  bool take_finish(const Event& event);
  bool offer(const Event& event);
  bool pass(const Event& event);
  bool pass_loose(const Event& event);

  void place_fragment();
  void forget_fragment();

  enum class Outlet : uint8_t { none, region, holes, loose, beginning };
  bool settle();
  Event next_event() const;
  void go_on();
  void end_chain();
  void begin_delivery(Outlet outlet, Event::Kind kind, uint32_t chain);
  void begin_next_hole();
  void begin_loose(uint32_t chain);
  void run_short();
  void let_all_go();
  bool begin_next_loose();

  bool end();
  bool begin_next_outer();
  bool send_finish();

  bool passes_loose() const { return unjoined_ == Unjoined::passed_on; }
  join::HeldChains& chains() { return waiting_.chains(); }
  const join::HeldChains& chains() const { return waiting_.chains(); }

  join::WaitingChains waiting_;
  join::RegionHoles
      region_;  // of the region that passes or is delivered, as far as the sink has it
  Sink sink_;
  JoinCapacities capacities_{0, 0};
  JoinReport report_{};
  InputOrder order_ = InputOrder::sweep;
  Unjoined unjoined_ = Unjoined::passed_on;
  SinkResult answer_ = SinkResult::accepted;  // of the sink, to the last event
  bool is_short_ = false;                     // of memory: everything is passed on

  // What becomes of the fragment that arrives, and the chain that holds it.
  enum class Fate : uint8_t { none, held, passed, ignored };
  Fate fate_ = Fate::none;
  uint32_t arriving_ = join::no_chain;

  // What is delivered: the next event, and of which chain. `holes` complete a region that passes; a
  // `beginning` is of the fragment that arrives.
  Outlet outlet_ = Outlet::none;
  Event::Kind next_kind_{};
  bool is_letting_go_ = false;  // of all chains, one after another
  uint32_t delivered_ = join::no_chain;
  uint32_t claimed_ = join::no_chain;  // the holes that follow
  uint32_t looked_at_ = 0;             // the last chain, on a walk over all

  // The sum of the `finish` events.
  bool has_start_ = false;
  bool has_finish_ = false;
  bool was_abandoned_ = false;
  uint32_t slices_ = 0;
  Statistics totals_{};
};

/// A sink for a receiver that wants whole regions alone, of a scan that may be short of memory:
///
///   static Joiner joiner;
///   extractor.start(limits, threshold, memory, make_region_sink(receiver, joiner, join_memory));
///
/// It starts the joiner, which calls `receiver.take(event)` and leaves out what it cannot join:
/// joiner.report() counts that. Each scan, or stream of a decoder, needs a new call, so an
/// Extractor is started again and not reset. Owner: all three must outlive the sink. Where the
/// memory is less than Joiner::minimum_bytes() the sink has no function, which start() refuses with
/// bad_sink.
///
/// Memory: 96 bytes per chain that waits and 12 per run of it; Joiner::high_water() counts both. On
/// the device that extracts, more memory for the extractor is better: there a chain takes 16 bytes
/// and 8 per three runs, and does not go loose at all. Cost: that of the Joiner.
template <class Receiver>
Sink make_region_sink(Receiver& receiver, Joiner& joiner, Memory memory) {
  const Status status =
      joiner.start(memory, make_sink(receiver), InputOrder::sweep, Unjoined::left_out);
  return status == Status::ok ? make_sink(joiner) : Sink{};
}

}  // namespace discmc

#endif
