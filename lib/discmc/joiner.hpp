// The joiner: loose fragments in, whole regions out.
//
// An extractor with little memory sends pieces of boundary rings early, as loose fragments. An
// extractor of a slab sends them at its seams. The joiner is a sink in front of another sink:
//
//   static Joiner joiner;
//   if (joiner.start(memory, sink, InputOrder::sweep) == Status::ok &&
//       decoder.start(make_sink(joiner)) == Status::ok)
//     ...  // push the stream
//   while (joiner.finish() == Status::suspended)
//     ...  // until the sink is ready again
//
// A fragment continues where another one ends, and no directed link belongs to two chains. So the
// ends of fragments match by vertex, incidence and direction, in any order of arrival. A chain that
// ends at its start is a ring. A hole waits until the outer ring around it, on the same plane, is
// closed.
//
// If the memory runs out, the joiner stops joining. It passes on everything that it holds and that
// arrives, as loose fragments, which a larger joiner can join. With Unjoined::dropped they are lost
// instead. A sink that needs whole regions uses make_region_sink().
#ifndef DISCMC_JOINER_HPP
#define DISCMC_JOINER_HPP

#include <discmc/join/region_holes.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Adds the totals of one scan to `sum`, for example those of each slab of a volume.
void add_totals(Statistics& sum, const Statistics& other);

/// The order of the incoming events.
enum class InputOrder : uint8_t {
  /// The order of one extractor or decoder. A region is delivered as soon as its outer ring closes.
  sweep,
  /// Any order, from one stream or several, such as those of slabs. Regions joined from fragments
  /// wait for finish(). Limit: the events from `region` to `region_end`, or from `fragment` to
  /// `fragment_end`, of one stream are not interrupted by events of another stream. A whole region
  /// arrives after the loose fragments that precede it in its own stream.
  any,
};

/// What happens to fragments that cannot be joined, because a partner or memory is missing.
enum class Unjoined : uint8_t {
  passed_on,  ///< the sink receives them as loose fragments
  dropped,    ///< they are lost: an outer ring with its whole region, a hole alone
};

/// The capacities of a joiner. Limit: at least 1 of each, and at most the constants; start() checks
/// it.
struct JoinCapacities {
  static constexpr uint32_t max_fragments = uint32_t{1} << 28;
  static constexpr uint32_t max_runs = UINT32_MAX - 1;

  uint32_t fragments;  ///< fragments and rings that wait at once
  uint32_t runs;       ///< the runs of all of them
};
static_assert(uint64_t{detail::join::WaitingTable::buckets_for(2)} *
                      JoinCapacities::max_fragments <=
                  UINT32_MAX,
              "32 bits count the buckets, and an entry: an index and two bits");

/// The counts of a joiner since its start.
struct JoinReport {
  uint64_t received = 0;  ///< loose fragments that arrived
  uint64_t invalid = 0;   ///< fragments dropped for an invalid incidence, direction or run
  uint64_t regions = 0;   ///< regions delivered whose outer ring was joined
  uint64_t rings = 0;     ///< joined rings delivered, as outer rings or as holes of any region
  /// Left at the end: chains without a partner, and holes without a region. Also fragments that
  /// start, or end, where another one does. A measure of what was lost before the joiner.
  uint64_t unmatched = 0;
  /// Chains that left for lack of memory, not joined or only partly joined.
  uint64_t short_of_memory = 0;
};

/// A sink in front of another sink. It completes regions from loose fragments, and passes on all
/// other events in their order. Any events are safe. Runs keep their normals.
///
/// A delivered region is complete if all its fragments arrived, whatever else is lost. Fragments
/// that report() counts as unmatched or short_of_memory reach the sink as loose fragments, or not
/// at all with Unjoined::dropped.
///
/// The sink receives one `finish` event, whose regions, rings and fragments are those that it
/// received. With InputOrder::any the event is the sum of all streams and comes from finish(), and
/// layer marks have no meaning.
///
/// A joiner is neither copied nor moved: two copies would write to the same memory. Cost: each run
/// of a fragment is copied once; each run of a region is compared with the holes that wait on its
/// plane.
class Joiner {
 public:
  Joiner() = default;

  /// The bytes of memory that start() needs for these capacities: 96 per fragment, and 12 per run.
  static constexpr uint64_t bytes_for(const JoinCapacities& capacities) {
    return detail::join::WaitingChains::bytes_for(capacities.fragments, capacities.runs) +
           Arena::alignment - 1;
  }
  /// The least memory with which start() succeeds.
  static constexpr uint64_t minimum_bytes() { return bytes_for({1, 1}); }

  /// The capacities that start() chooses for this many bytes: one fragment with eight runs per 192
  /// bytes.
  static constexpr JoinCapacities default_capacities(uint64_t bytes) {
    // In 32 bits: no 64-bit division on small machines.
    constexpr uint64_t unused = bytes_for({0, 0});
    const uint64_t units = bytes <= unused ? 0 : (bytes - unused) >> 6;
    const uint32_t affordable = static_cast<uint32_t>(units < UINT32_MAX ? units : UINT32_MAX) / 3;
    if (affordable == 0) return {1, 1};
    const uint32_t fragments =
        affordable < JoinCapacities::max_fragments ? affordable : JoinCapacities::max_fragments;
    return {fragments, 8 * fragments};
  }

  /// Starts with default_capacities(), and drops what an earlier start() left. memory: at least
  /// minimum_bytes(), at any alignment; Owner: the caller, for as long as events arrive. sink:
  /// receives the joined events. Errors: bad_sink (no function), too_little_memory; then nothing
  /// has changed.
  [[nodiscard]] Status start(Memory memory, const Sink& sink, InputOrder order,
                             Unjoined unjoined = Unjoined::passed_on);
  /// As above, with explicit capacities. Errors: also bad_capacities.
  [[nodiscard]] Status start(const JoinCapacities& capacities, Memory memory, const Sink& sink,
                             InputOrder order, Unjoined unjoined = Unjoined::passed_on);

  /// Accepts an event, and delivers what the event completes. Returns SinkResult::busy if the sink
  /// is busy: the sender offers the event again. Returns SinkResult::not_started before start(),
  /// and if the sink returns it.
  SinkResult accept(const Event& event);

  /// Ends the input, and delivers what waits. With InputOrder::sweep the `finish` event does so by
  /// itself; call finish() anyway, for the status, and for streams without a trailer.
  /// Status::suspended: the sink is busy, call finish() again. Errors: not_started; bad_sink (the
  /// sink answered not_started); too_little_memory (memory was short at some time; everything that
  /// could be joined was delivered).
  [[nodiscard]] Status finish();

  const JoinReport& report() const { return report_; }
  JoinCapacities capacities() const { return capacities_; }
  /// The peak: the most that was held at once.
  JoinCapacities peaks() const { return {chains().peak(), chains().run_peak()}; }

 private:
  Joiner(const Joiner&) = default;
  Joiner& operator=(const Joiner&) = default;  // start() resets it

  bool process(const Event& event);
  bool begin_fragment(const Event& event);
  bool add_run(const Event& event);
  bool end_fragment(const Event& event);
  bool end_region(const Event& event);
  bool lose(const Event& event);
  bool process_start(const Event& event);
  bool process_finish(const Event& event);
  bool offer(const Event& event);
  bool pass(const Event& event);
  bool pass_loose(const Event& event);

  void place_fragment();
  void forget_fragment();

  enum class Outlet : uint8_t { none, region, holes, loose, beginning };
  bool deliver_pending();
  Event next_event() const;
  void select_next();
  void end_chain();
  void begin_delivery(Outlet outlet, Event::Kind kind, uint32_t chain);
  void begin_next_hole();
  void begin_loose(uint32_t chain);
  void start_passing();
  void deliver_all_loose();
  bool begin_next_loose();

  bool end();
  bool begin_next_outer();
  bool send_finish();

  bool passes_loose() const { return unjoined_ == Unjoined::passed_on; }
  detail::join::HeldChains& chains() { return waiting_.chains(); }
  const detail::join::HeldChains& chains() const { return waiting_.chains(); }

  detail::join::WaitingChains waiting_;
  detail::join::RegionHoles region_;  // holes of the region that the sink is receiving
  Sink sink_;
  JoinCapacities capacities_{0, 0};
  JoinReport report_{};
  InputOrder order_ = InputOrder::sweep;
  Unjoined unjoined_ = Unjoined::passed_on;
  SinkResult answer_ = SinkResult::accepted;  // of the sink, to the last event
  bool is_short_ = false;                     // whether memory is short: all events are passed on

  // The fate of the arriving fragment, and the chain that holds it.
  enum class Fate : uint8_t { none, held, passed, ignored };
  Fate fate_ = Fate::none;
  uint32_t arriving_ = detail::join::no_chain;

  // The current delivery: the next event, and its chain. `holes` complete a region that passes
  // through; a `beginning` belongs to the arriving fragment.
  Outlet outlet_ = Outlet::none;
  Event::Kind next_kind_{};
  bool is_delivering_all_ = false;  // whether all held chains are delivered as loose
  uint32_t delivered_ = detail::join::no_chain;
  uint32_t claimed_ = detail::join::no_chain;  // the holes that follow
  uint32_t last_visited_ = 0;                  // the last chain, while all are delivered

  // The sum of the `finish` events.
  bool has_start_ = false;
  bool has_finish_ = false;
  bool is_abandoned_ = false;
  uint32_t slices_ = 0;
  Statistics totals_{};
};

/// Returns a sink for an object that needs whole regions, although the scan may have little memory:
///
///   static Joiner joiner;
///   extractor.start(limits, threshold, memory, make_region_sink(object, joiner, join_memory));
///
/// It starts the joiner, with `object.accept(event)` as the joiner's sink. Fragments that cannot be
/// joined are dropped; joiner.report() counts them. Call make_region_sink() again for each scan,
/// and start the extractor with the result instead of calling reset(). Owner: object, joiner and
/// memory must outlive the sink. If the memory is less than Joiner::minimum_bytes(), the returned
/// sink has no function, and start() of the extractor returns bad_sink.
///
/// Cost: 96 bytes per waiting fragment and 12 per run of it; Joiner::peaks() counts both. On the
/// device that extracts, give the extractor more memory instead. The extractor needs only 16 bytes
/// per waiting chain and 8 per three runs, and then sends fewer loose fragments.
template <class Object>
Sink make_region_sink(Object& object, Joiner& joiner, Memory memory) {
  const Status status =
      joiner.start(memory, make_sink(object), InputOrder::sweep, Unjoined::dropped);
  return status == Status::ok ? make_sink(joiner) : Sink{};
}

}  // namespace discmc

#endif
