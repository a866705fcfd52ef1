// The events of extractors and decoders, and the sinks that receive them.
//
// A sink is a function with a context. It receives events in a fixed grammar and answers
// `accepted`, `busy` or `not_started`. The next resume() offers a refused event again, unchanged.
//
//   scan     = start { region | fragment | skipped | layer | application | fractions } finish
//   region   = region { ring { run } } region_end         outer ring first, then the holes
//   fragment = fragment { run } fragment_end              for lack of memory, or at a slab's seam
//
// Only decoders send `application`, and only receivers `fractions`. A decoder may send `lost`
// instead of the rest of a region or fragment. A truncated stream has no `finish`; a stream whose
// header is lost has its `start` late, or none.
//
// All fragments are loose: pieces of a ring that were sent before the ring was closed. Fragment B
// continues fragment A if three things match:
//
//   - their incidences
//   - the start of B and the end of A
//   - the incoming direction of B and the direction of A's last run
//
// No other fragment matches, because each directed link belongs to one ring. A fragment that is a
// whole ring continues itself. If the runs on both sides of a joint have the same direction, the
// joint is no corner. All loose fragments of a region's holes come before the outer ring of the
// region, or before the last fragment of that ring.
//
// A sink that ignores the events from `fragment` to `fragment_end` receives an incomplete surface.
// It lacks regions with a loose outer ring, and the loose holes of others. Statistics::fragments
// counts the fragments. make_region_sink() in joiner.hpp joins them, and sends whole regions to a
// sink.
#ifndef DISCMC_SINK_HPP
#define DISCMC_SINK_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>
#include <discmc/chain.hpp>
#include <discmc/limits.hpp>
#include <discmc/normal.hpp>
#include <discmc/status.hpp>

namespace discmc {

// ---- Application records: your own data in a stream, such as a time stamp, a pose or a battery's
// state.

/// A record is sent at once, in its own packet. It costs 22 bytes beyond its data, and ends the
/// previous packet early, so prefer few large records.
struct ApplicationRecord {
  static constexpr size_t max_bytes = 200;
  /// The first standard kind; see placement.hpp.
  static constexpr uint8_t first_standard_kind = 240;

  uint8_t kind = 0;    ///< yours; Limit: below first_standard_kind, which is not checked because
                       ///< standard records use the same call
  uint32_t slice = 0;  ///< complete slices at this point of the scan
  uint32_t row = 0;    ///< complete rows of the next slice
  const uint8_t* bytes = nullptr;  ///< Owner: the caller, or the sender of the event; valid during
                                   ///< the call
  size_t count = 0;                ///< Limit: at most max_bytes
};

// ---- The description of a scan in its stream.

/// For a decoder that accepts the first stream on any channel.
constexpr uint8_t any_channel = 255;

/// The data with which an encoder describes a scan; the extractor supplies the rest.
struct StreamLabel {
  static constexpr uint8_t max_channel = 63;
  /// Whether a decoder can receive the channel.
  static constexpr bool is_receivable(uint8_t channel) {
    return channel <= max_channel || channel == any_channel;
  }

  uint32_t depth = 0;                 ///< planned slices; 0 if unknown
  int32_t spacing_nm[3] = {0, 0, 0};  ///< between voxels; negative for a mirrored axis; 0 unknown;
                                      ///< ignored if the extractor supplies it
  uint16_t scan = 0;    ///< a number that no other scan on the link has: the device's number and a
                        ///< count of its scans, for example
  uint8_t channel = 0;  ///< of the surface, if several surfaces share a link; Limit: at most
                        ///< max_channel
};

/// The header of a stream.
struct StreamHeader {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t depth = 0;                 ///< planned slices; 0 if unknown
  int32_t spacing_nm[3] = {0, 0, 0};  ///< between voxels; negative for a mirrored axis; 0 unknown
  static constexpr uint8_t max_surfaces = 4;
  int32_t thresholds[max_surfaces] = {};  ///< per surface: on if the sample is at least this
  Border border = Border::closed;
  uint8_t channel = 0;  ///< of the first surface, if a stream of slices has several
  uint16_t scan = 0;
  uint8_t surface_count = 1;  ///< on consecutive channels; Limit: 1 to max_surfaces in a stream of
                              ///< slices, else 1
  uint8_t levels = 0;         ///< of the fractions in a stream of slices: 2 or 4; 0: it has none

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

// ---- Events and sinks.

/// The answer of a sink to an event.
enum class SinkResult : uint8_t {
  accepted,     ///< the sink has processed the event
  busy,         ///< not now: the next resume(), or push() of a decoder, offers the event again
  not_started,  ///< the sink has not started: a retry fails again. An extractor then does not
                ///< start; decoders and joiners return bad_sink. During a scan, an extractor treats
                ///< not_started as `busy`.
};

/// The status of a decoder or joiner whose sink has not accepted an event.
constexpr Status status_of(SinkResult answer) {
  return answer == SinkResult::not_started ? Status::bad_sink : Status::suspended;
}

/// The totals of a scan so far. For slabs: the two slabs at a seam share its cells, and each rounds
/// its counts down. So over all slabs, the sums of `cells`, `facets` and `classic_triangles` are at
/// most one too low per seam.
struct Statistics {
  uint64_t cells;              ///< cells that contain surface
  uint64_t facets;             ///< in these cells, before the merge to regions
  uint64_t classic_triangles;  ///< that classic Marching Cubes would make in these cells
  uint64_t regions;            ///< delivered whole
  uint64_t rings;              ///< of these regions, holes included
  uint64_t links;              ///< the sum of the lengths of all delivered runs
  uint64_t fragments;          ///< loose fragments delivered
  uint64_t skipped_rows;       ///< calls of skip_row(); rows after abandon() are not counted
};

/// One event. Only the members that its kind names are valid.
struct Event {
  enum class Kind : uint8_t {
    start,         ///< the first event: header
    region,        ///< a complete region begins: incidence
    ring,          ///< one of its rings begins: start, is_hole
    run,           ///< the next run of the ring or fragment: run, normal
    region_end,    ///< the region is complete
    fragment,      ///< a loose fragment begins: incidence, start, incoming_direction
    fragment_end,  ///< the fragment is complete
    skipped,       ///< a row is missing: slice, row, is_repeated
    layer,         ///< a slice is complete: slice; every region that does not reach it has been
                   ///< delivered
    application,   ///< an application record: application
    finish,        ///< the last event: slice (number of slices; of a slab, its own), is_abandoned,
                   ///< statistics
    lost,          ///< decoders only: part of the current region or fragment is lost; discard it
    fractions,     ///< receivers only: where the surface crosses the edges of a row of voxels:
                   ///< slice, row, fractions
  };
  Kind kind;
  Incidence incidence;
  Direction incoming_direction;  ///< of the link that leads to the start of a fragment
  bool is_hole;
  bool is_repeated;  ///< the row was replaced by the previous row
  bool is_abandoned;
  OctahedralNormal normal;  ///< at the start of the run, in space: see unit_normal(); none if the
                            ///< samples are level there, or if extractor or stream lack normals
  Run run;
  uint32_t slice;
  uint32_t row;
  Vertex start;  ///< Units: half-steps
  /// Owner: the sender; valid during the call.
  union {
    const Statistics* statistics;
    const StreamHeader* header;  ///< of an extractor: without depth, scan and channel
    const ApplicationRecord* application;
    const uint16_t* fractions;  ///< one entry per voxel of the row: fraction_of() in fraction.hpp
  };
};

/// A sink of events: a function, and the object that it is called with. Owner: the context belongs
/// to the caller and must outlive the scan.
///
/// An extractor, decoder or joiner calls its sink's accept() during its own calls, in the caller's
/// thread. accept() may block. It may call any other object, and queries of the sender such as
/// slices(), but no function that changes or saves the sender. It must not throw: the library is
/// compiled without exceptions. Nothing is locked (docs/front-end.md).
struct Sink {
  void* context = nullptr;
  SinkResult (*accept)(void* context, const Event& event) = nullptr;
};

/// Returns a sink that calls `object.accept(event)` with every event. Owner: the object must
/// outlive the sink.
template <class Object>
Sink make_sink(Object& object) {
  return {&object, [](void* context, const Event& event) {
            return static_cast<Object*>(context)->accept(event);
          }};
}

}  // namespace discmc

#endif
