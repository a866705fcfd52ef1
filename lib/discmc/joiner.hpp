// The joiner: loose fragments in, regions out.
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
// A fragment continues at the end of its last link, and no directed link belongs to two chains. So
// ends match by vertex, incidence and direction, in any order of arrival. A chain that ends at its
// start is a ring. A hole waits for the outer ring around it, on the same plane.
//
// Too little memory loses nothing: from then on the joiner passes on what it holds and what
// arrives, and a larger joiner can join that. For a sink that needs whole regions, use
// make_region_sink().
#ifndef DISCMC_JOINER_HPP
#define DISCMC_JOINER_HPP

#include <discmc/join/region_holes.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Adds the totals of a scan to a sum, as for the slabs of one volume.
void add(Statistics& sum, const Statistics& other);

/// The order of the incoming events.
enum class InputOrder : uint8_t {
  /// The order of one sweep. The joiner delivers a region as soon as its outer ring closes.
  sweep,
  /// Loose fragments in any order, from one stream or several. Regions joined from them wait for
  /// finish(). Limit: between `region` and `region_end`, or `fragment` and `fragment_end`, of one
  /// stream comes no event of another. A region that arrives whole comes after the loose fragments
  /// that its own stream has before it.
  any,
};

/// The fate of fragments that the joiner cannot join, for lack of a partner or of memory.
enum class Unjoined : uint8_t {
  passed_on,  ///< to the sink, as loose fragments
  left_out,   ///< dropped, with the regions or holes that they belong to
};

/// The capacities of a joiner. Limit: at least 1 of each.
struct JoinCapacities {
  static constexpr uint32_t max_fragments = uint32_t{1} << 28;
  static constexpr uint32_t max_runs = UINT32_MAX - 1;

  uint32_t fragments;  ///< chains not closed yet, and rings that wait
  uint32_t runs;       ///< of all of them
};

/// The counts of a joiner since its start.
struct JoinReport {
  uint64_t received = 0;   ///< fragments
  uint64_t invalid = 0;    ///< dropped: the incidence, a direction or a run is invalid
  uint64_t regions = 0;    ///< delivered, with outer rings joined from fragments
  uint64_t rings = 0;      ///< joined from fragments, and delivered in any region
  uint64_t unmatched = 0;  ///< at the end: chains without a partner, holes without a region, and
                           ///< fragments that collided with another; the measure of what was lost
  uint64_t passed_on = 0;  ///< fragments, some of them partly joined, that were passed on for lack
                           ///< of memory
};

/// Receives the events of extractors and decoders, and sends them on with regions completed and
/// joined. Any events are safe.
///
/// The sink receives everything except loose fragments in the original order. It receives what the
/// report counts as unmatched or passed on as loose fragments, unless these are left out. Runs keep
/// their normals. A region is right if all its fragments arrived, whatever else is lost.
///
/// The sink receives one `finish` event. With several streams in any order it is the sum, sent by
/// finish(). Its counts of regions, rings and loose fragments are those that the joiner delivered.
/// Layer marks are valid only in the order of a sweep.
///
/// A joiner is neither copied nor moved: two copies would write to the same memory.
///
/// Cost: per fragment, its runs; per region, its runs times the holes that wait on its plane.
class Joiner {
 public:
  Joiner() = default;

  /// The bytes of the caller's memory for these capacities, and the minimum.
  static constexpr uint64_t bytes_for(const JoinCapacities& capacities) {
    return join::WaitingChains::bytes_for(capacities.fragments, capacities.runs) +
           Arena::alignment - 1;
  }
  static constexpr uint64_t minimum_bytes() { return bytes_for({1, 1}); }

  /// The default split of a number of bytes: eight runs per fragment, in 192 bytes.
  static constexpr JoinCapacities default_capacities(uint64_t bytes) {
    // In 32 bits: no 64-bit division on small machines.
    const uint64_t units = bytes < Arena::alignment ? 0 : (bytes - (Arena::alignment - 1)) >> 6;
    const uint32_t affordable = static_cast<uint32_t>(units < UINT32_MAX ? units : UINT32_MAX) / 3;
    if (affordable == 0) return {1, 1};
    const uint32_t fragments =
        affordable < JoinCapacities::max_fragments ? affordable : JoinCapacities::max_fragments;
    return {fragments, 8 * fragments};
  }

  /// Starts anew, with the default split of the memory. memory: Owner: the caller, for as long as
  /// events arrive. Errors: bad_sink, too_little_memory; then nothing has changed.
  [[nodiscard]] Status start(Memory memory, const Sink& sink, InputOrder order,
                             Unjoined unjoined = Unjoined::passed_on);
  /// As above, with explicit capacities. Errors: also bad_capacities.
  [[nodiscard]] Status start(const JoinCapacities& capacities, Memory memory, const Sink& sink,
                             InputOrder order, Unjoined unjoined = Unjoined::passed_on);

  /// Accepts an event, and delivers what the event completes. Returns SinkResult::not_started
  /// before start(), and if the sink returns it.
  SinkResult take(const Event& event);

  /// Ends the input, and delivers what waits; a `finish` event in the order of a sweep does so,
  /// too. Status::suspended: the sink is busy, call again. Errors: not_started; bad_sink (the sink
  /// answered not_started); too_little_memory if memory was short at any time, although everything
  /// possible was delivered.
  [[nodiscard]] Status finish();

  const JoinReport& report() const { return report_; }
  JoinCapacities capacities() const { return capacities_; }
  /// The peak: the most that was held at once.
  JoinCapacities high_water() const { return {chains().high_water(), chains().run_high_water()}; }

 private:
  Joiner(const Joiner&) = default;
  Joiner& operator=(const Joiner&) = default;  // start() resets it

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

  // The fate of the arriving fragment, and the chain that holds it.
  enum class Fate : uint8_t { none, held, passed, ignored };
  Fate fate_ = Fate::none;
  uint32_t arriving_ = join::no_chain;

  // What is being delivered: the next event, and its chain. `holes` complete a region that passes
  // through; a `beginning` belongs to the arriving fragment.
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

/// Returns a sink for an object that needs whole regions, of a scan that may have little memory:
///
///   static Joiner joiner;
///   extractor.start(limits, threshold, memory, make_region_sink(object, joiner, join_memory));
///
/// It starts the joiner, which calls `object.take(event)` and drops what it cannot join;
/// joiner.report() counts the drops. Call it anew for each scan or stream: start the extractor
/// again instead of reset(). Owner: object, joiner and memory must outlive the sink. If the
/// memory is less than Joiner::minimum_bytes(), the sink has no function, and start() returns
/// bad_sink.
///
/// Memory: 96 bytes per waiting chain and 12 per run of it; Joiner::high_water() counts both. On
/// the device that extracts, give the extractor more memory instead: there a chain needs 16 bytes,
/// and 8 per three runs, and is not sent loose at all. Cost: as the Joiner.
template <class Object>
Sink make_region_sink(Object& object, Joiner& joiner, Memory memory) {
  const Status status =
      joiner.start(memory, make_sink(object), InputOrder::sweep, Unjoined::left_out);
  return status == Status::ok ? make_sink(joiner) : Sink{};
}

}  // namespace discmc

#endif
