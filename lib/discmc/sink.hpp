// What the extractor hands out, and to whom.
//
// A sink is one function with a context. It is offered events in a fixed grammar and answers
// `accepted`, `busy` or `not_started`; what it did not take is offered again, unchanged, on the
// next resume().
//
//   scan     = start { region | fragment | skipped | layer | application } finish
//   region   = region { ring { run } } region_end         outer ring first, then the holes
//   fragment = fragment { run } fragment_end              for lack of memory, or at a slab's seam
//
// `start` must be taken at once: an extractor whose sink does not is not started. Only decoders
// send `application`. A decoder may put `lost` in place of the rest of a region or fragment; a
// stream that breaks off has no `finish`, and one whose header is late has its `start` late, or
// none.
//
// A fragment is loose: a piece of a boundary ring, sent early for lack of memory, complete in
// itself. Fragment E follows fragment F where both have the same incidence, E starts where F's runs
// end, and E came there by the direction of F's last run. A directed link belongs to one chain, so
// there is one match at most. Where two fragments are joined, runs of one direction may meet: that
// is no corner. A ring that goes out loose as a whole is a fragment that follows itself. All loose
// fragments of a region's holes come before its outer ring, or the last fragment of it.
//
// A sink that passes over fragments (all events from `fragment` to `fragment_end`) gets an
// incomplete surface: regions whose outer ring went out loose are missing, and others lack the
// holes that did. Statistics::fragments counts them. make_region_sink() in joiner.hpp gives a sink
// whole regions.
#ifndef DISCMC_SINK_HPP
#define DISCMC_SINK_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/chain.hpp>
#include <discmc/compiler.hpp>
#include <discmc/limits.hpp>
#include <discmc/normal.hpp>
#include <discmc/status.hpp>

namespace discmc {

// ---- The user's own data in a stream: a time stamp, a pose, the state of a battery.

/// A record goes out at once, in a packet of its own, which takes 22 bytes more than its data, and
/// ends the packet before it early. So tell rarely, and much at once.
struct ApplicationRecord {
  static constexpr size_t max_bytes = 200;
  /// Kinds from here on have a meaning of their own: placement.hpp.
  static constexpr uint8_t first_standard_kind = 240;

  uint8_t kind = 0;    ///< the user's; Limit: below first_standard_kind, which is not checked, as
                       ///< standard records are told in the same way
  uint32_t slice = 0;  ///< where the scan was: as many slices and rows were complete
  uint32_t row = 0;
  const uint8_t* bytes = nullptr;  ///< Owner: whoever tells it; free again when the call returns
  size_t count = 0;                ///< Limit: at most max_bytes
};

// ---- What a stream says of its scan, and what an encoder has to be told of it.

/// For a decoder that takes the first stream that comes, of whatever channel.
constexpr uint8_t any_channel = 255;

/// What an encoder is told of a scan. The rest the extractor knows.
struct StreamLabel {
  static constexpr uint8_t max_channel = 63;

  uint32_t depth = 0;                 ///< planned slices; 0 when not known
  int32_t spacing_nm[3] = {0, 0, 0};  ///< between voxels; negative for a mirrored axis; 0 unknown;
                                      ///< not read where the extractor was told it
  uint16_t scan = 0;                  ///< a number that no other scan on the link has, such as a
                                      ///< device's own and a count of its scans
  uint8_t channel = 0;  ///< of the surface, where several share a link; Limit: at most
                        ///< max_channel
};

/// What a stream says of its scan.
struct StreamHeader {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t depth = 0;                 ///< planned slices; 0 when not known
  int32_t spacing_nm[3] = {0, 0, 0};  ///< between voxels; negative for a mirrored axis; 0 unknown
  static constexpr uint8_t max_surfaces = 4;
  int32_t thresholds[max_surfaces] = {};  ///< of each surface: a voxel is on where its sample is at
                                          ///< least this
  Border border = Border::closed;
  uint8_t channel = 0;  ///< of the first surface, where a stream of slices has several
  uint16_t scan = 0;
  uint8_t surface_count = 1;  ///< on consecutive channels; Limit: 1 to max_surfaces in a stream of
                              ///< slices, else 1

  constexpr bool is_valid() const {
    return Limits{width, height, border}.is_valid() && surface_count >= 1 &&
           surface_count <= max_surfaces && channel + surface_count - 1 <= StreamLabel::max_channel;
  }
  constexpr bool has_spacing() const {
    return spacing_nm[0] != 0 || spacing_nm[1] != 0 || spacing_nm[2] != 0;
  }
  constexpr StreamLabel label() const {
    return {depth, {spacing_nm[0], spacing_nm[1], spacing_nm[2]}, scan, channel};
  }
};

// ---- Events, and who takes them.

/// What a sink says of an event.
enum class SinkResult : uint8_t {
  accepted,
  busy,
  not_started,  ///< the sink was not started, and asking again is of no use. Extractors are not
                ///< started then; decoders and joiners say bad_sink. To an extractor at work it is
                ///< as `busy`.
};

/// What a decoder or joiner says when its sink has not taken an event.
constexpr Status status_of(SinkResult answer) {
  return answer == SinkResult::not_started ? Status::bad_sink : Status::suspended;
}

/// Totals of a scan so far. All are exact, but for slabs: of the cells at a seam either slab counts
/// a part, and drops what is not whole in the end. So the first three counts of a volume's slabs
/// add up to those of the volume, less one a seam at most.
struct Statistics {
  uint64_t cells;              ///< that the surface passes through
  uint64_t facets;             ///< in them, before they are merged to regions
  uint64_t classic_triangles;  ///< that classic Marching Cubes would have made in them
  uint64_t regions;            ///< delivered whole
  uint64_t rings;              ///< of these regions, holes included
  uint64_t links;              ///< of rings and loose fragments: the lengths of all runs delivered
  uint64_t fragments;          ///< loose ones, delivered
  uint64_t skipped_rows;       ///< that never came, by skip_row(); not those after abandon()
};

/// One thing that a sink is offered. Only the members that its kind names have a meaning.
struct Event {
  enum class Kind : uint8_t {
    start,         ///< the first event: header
    region,        ///< a complete region begins: incidence
    ring,          ///< one of its rings begins: start, hole
    run,           ///< the next run of the ring or fragment: run, normal
    region_end,    ///< the region is complete
    fragment,      ///< a loose fragment begins: incidence, start, incoming_direction
    fragment_end,  ///< the fragment is complete
    skipped,       ///< a row never came: slice, row; `repeated` when the row before stood in for it
    layer,         ///< every region that does not reach `slice` has been delivered
    application,   ///< the user's own data: application
    finish,        ///< the last event: slice (how many: of a slab its own), abandoned, statistics
    lost,          ///< decoder only: part of the region or fragment just begun is lost, forget it
  };
  Kind kind;
  Incidence incidence;
  Direction incoming_direction;  ///< of the link by which a fragment's chain comes to its start
  bool hole;
  bool repeated;
  bool abandoned;
  OctahedralNormal normal;  ///< where the run starts, in space: see unit_normal(); none where there
                            ///< is no gradient, without GradientNormals, or in a stream without
  Run run;
  uint32_t slice;
  uint32_t row;
  Vertex start;  ///< Units: half-steps
  /// Owner: the sender; valid during the call.
  union {
    const Statistics* statistics;
    const StreamHeader*
        header;  ///< of an extractor, what it knows: not the depth, scan and channel
    const ApplicationRecord* application;
  };
};

/// Where events go. Owner: the context belongs to the caller and must outlive the scan.
///
/// take() is called within calls of the object that has the sink, by the same thread, and at no
/// other time. It may wait, and call functions of other objects. Of that object it may call those
/// that tell something, such as slices(), but none that does something or saves. It must not throw:
/// the library is compiled without exceptions. Nothing is locked: all calls of an object come from
/// one context at a time, and from an interrupt only where none come from elsewhere.
struct Sink {
  void* context = nullptr;
  SinkResult (*take)(void* context, const Event& event) = nullptr;
};

/// A sink that calls `receiver.take(event)` with every event. Owner: the receiver must outlive the
/// sink.
template <class Receiver>
Sink make_sink(Receiver& receiver) {
  return {&receiver, [](void* context, const Event& event) {
            return static_cast<Receiver*>(context)->take(event);
          }};
}

}  // namespace discmc

#endif
