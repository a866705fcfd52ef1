// The receiver of a surface's events during extraction.
#pragma once

#include <cstdint>
#include <discmc/encoder.hpp>
#include <discmc/placement.hpp>
#include <discmc/sink.hpp>
#include <optional>

#include "meshing.hpp"
#include "require.hpp"
#include "samples/volume_placement.hpp"
#include "surface/joined_surface.hpp"

namespace discmc::command {

/// Writes the placement of the volume to a stream, if there is one. encoder: started; its output
/// must accept everything.
template <class Encoder>
void write_placement(const std::optional<VolumePlacement>& placement, Encoder& encoder) {
  if (!placement) return;
  std::uint8_t bytes[Placement::record_bytes];
  require(encoder.write_record(record_of(in_nanometres(*placement), bytes)));
}

/// Writes the range of slices to the stream of a slab. encoder: as write_placement().
template <class Encoder>
void write_slab(const std::optional<SlabRange>& slab, Encoder& encoder) {
  if (!slab) return;
  std::uint8_t bytes[SlabRange::record_bytes];
  require(encoder.write_record(record_of(*slab, bytes)));
}

/// Passes every event to an encoder, if a stream is begun. Joins the events to a surface, if one is
/// kept.
class SurfaceReceiver {
 public:
  SurfaceReceiver(std::optional<Kept> kept, unsigned jobs)
      : surface_(kept.value_or(Kept::counts), jobs), builds_(kept.has_value()) {}

  /// Begins a stream. output: must accept everything; Owner: the caller.
  void start_stream(const StreamLabel& label, const std::optional<VolumePlacement>& placement,
                    const std::optional<SlabRange>& slab, const ByteOutput& output) {
    encoder_.encode_normals();
    require(encoder_.start(label, output));
    placement_ = placement;
    slab_ = slab;
    encodes_ = true;
  }

  SinkResult accept(const Event& event) {
    if (encodes_ && encoder_.accept(event) != SinkResult::accepted) return SinkResult::busy;
    if (encodes_ && event.kind == Event::Kind::start) {
      write_placement(placement_, encoder_);
      write_slab(slab_, encoder_);
    }
    return builds_ ? surface_.accept(event) : SinkResult::accepted;
  }

  /// Accepts a region in place of its events, unless they must be encoded.
  SinkResult accept_region(const OneRingRegion& region) {
    if (encodes_ || !builds_) return SinkResult::busy;
    return surface_.accept_region(region);
  }

  /// Returns the size of the stream; 0 without a stream.
  std::uint64_t stream_bytes() const { return encodes_ ? encoder_.bytes() : 0; }
  /// Returns the builder that accepts regions in place of their events; null if regions are not
  /// kept.
  SurfaceBuilder* builder() { return builds_ ? &surface_.builder() : nullptr; }
  /// Returns the encoder that accepts packets; null without a stream.
  Encoder* encoder() { return encodes_ ? &encoder_ : nullptr; }
  /// Limit: Kept::polygons. The caller sets the spacing.
  Surface& surface() { return surface_.surface(); }
  /// Limit: Kept::counts.
  const Counts& counts() const { return surface_.builder().counts(); }

 private:
  Encoder encoder_;
  std::optional<VolumePlacement> placement_;
  std::optional<SlabRange> slab_;
  JoinedSurface surface_;
  bool encodes_ = false;
  bool builds_;
};

}  // namespace discmc::command
