// What the extractor hands out, and to whom.
//
// A sink is one function with a context. It is offered events in a fixed grammar and answers
// `taken` or `not_now`; what it did not take is offered again, unchanged, on the next resume().
//
//   scan     = { region | fragment | skipped | layer } finish
//   region   = region { ring { run } } region_end         outer ring first, then the holes
//   fragment = fragment { run } fragment_end              only when the sink takes fragments
//
// A decoder may put `lost` in place of the rest of a region or fragment, and a stream that breaks
// off has no `finish`.
//
// A loose fragment is a piece of a boundary ring, sent early, complete in itself. It is followed by
// the fragment of its incidence that starts where it ends and came there in the direction of its
// last run; there is only one. A ring that is sent loose as a whole follows itself. Within a sweep
// all fragments of a region's holes are sent before its outer ring, or the last fragment of that.
#ifndef DISCMC_SINK_HPP
#define DISCMC_SINK_HPP

#include <discmc/chain.hpp>
#include <discmc/normal.hpp>

namespace discmc {

enum class Answer : uint8_t { taken, not_now };

/// Totals of a scan so far. All counts are exact; none wraps in practice (64 bits).
struct Statistics {
  uint64_t cells;              ///< active cells swept
  uint64_t facets;             ///< before merging
  uint64_t classic_triangles;  ///< what classic Marching Cubes would have made
  uint64_t regions;            ///< delivered
  uint64_t rings;              ///< delivered
  uint64_t links;              ///< of all chains, delivered
  uint64_t cuts;               ///< links made boundary for lack of memory
  uint64_t spills;             ///< fragments sent early for lack of memory
  uint64_t skipped_rows;
};

/// One thing that a sink is offered. Only the members that its kind names have a meaning.
struct Event {
  enum class Kind : uint8_t {
    region,        ///< a complete region begins: incidence
    ring,          ///< one of its rings begins: start, hole
    run,           ///< the next run of the ring or fragment: run, normal
    region_end,    ///< the region is complete
    fragment,      ///< a loose fragment begins: incidence, start, came
    fragment_end,  ///< the fragment is complete
    skipped,       ///< a row never came: slice, row; `repeated` when the row before stood in for it
    layer,         ///< every region that does not reach `slice` has been delivered
    finish,        ///< the last event: slice (how many slices), abandoned, statistics
    lost,          ///< decoder only: part of the region or fragment just begun is lost, forget it
  };
  Kind kind;
  Incidence incidence;
  Direction came;  ///< of the link by which a loose fragment's chain comes to its start
  bool hole;
  bool repeated;
  bool abandoned;
  OctahedralNormal normal;  ///< where the run starts, in space: see unit_normal(); none where there
                            ///< is no gradient, without GradientNormals, or in a stream without
  Run run;
  uint32_t number;
  uint32_t slice;
  uint32_t row;
  Vertex start;                  ///< Units: half-steps
  const Statistics* statistics;  ///< Owner: the sender; valid during the call
};

/// Where events go. Owner: the context belongs to the caller and must outlive the scan.
struct Sink {
  void* context = nullptr;
  Answer (*take)(void* context, const Event& event) = nullptr;
  bool takes_fragments = true;  ///< false: a lack of memory is answered by cuts instead of spills
};

/// A sink that calls `receiver.take(event)`. Owner: the receiver must outlive the sink.
template <class Receiver>
Sink sink_to(Receiver& receiver, bool takes_fragments = true) {
  return {&receiver,
          [](void* context, const Event& event) {
            return static_cast<Receiver*>(context)->take(event);
          },
          takes_fragments};
}

}  // namespace discmc

#endif
