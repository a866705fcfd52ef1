// The surface decoder: bytes of a stream of either kind in, events of the scan out.
//
// From a stream of regions it decodes the events of the scan. From a stream of slices it extracts
// the surface, as the device would have done: the events are those of an extractor that receives
// the same rows, including skipped ones. Rows lost in transit count as skipped rows that are off.
// So a closed border still has a closed surface, and `skipped` events locate the loss.
//
// It delivers one surface. If a stream has several surfaces, use one decoder per channel, and push
// all bytes to each. Give each the memory for all surfaces, because a further surface is decoded
// from the rows of the first. decoder.hpp explains links that carry scan after scan;
// examples/link.cpp shows both.
#ifndef DISCMC_SURFACE_DECODER_HPP
#define DISCMC_SURFACE_DECODER_HPP

#include <discmc/extractor.hpp>
#include <discmc/slice_decoder.hpp>

namespace discmc {

/// The least memory for streams of slices of this size with this many surfaces: 29,766 bytes for
/// one surface of 256x256. More memory becomes slots of 16 bytes each, as in an Extractor32, so
/// that fewer regions arrive as loose fragments. For CT head (Stanford), 128 KiB suffice for 99 %
/// of the regions, and 176 KiB for all. A Joiner joins the rest. Limit: valid limits.
constexpr uint64_t minimum_surface_bytes(const Limits& limits, uint32_t surfaces = 1) {
  return slice_decoder_bytes(limits, surfaces) + minimum_bytes<uint32_t>(limits);
}

/// Decodes one stream of either kind, and sends the events of one of its surfaces to a Sink. A
/// decoder contains pointers to itself, so it is neither copied nor moved.
class SurfaceDecoder {
 public:
  /// The most lost rows that one call skips, because a hostile stream can claim any number of them.
  static constexpr uint32_t max_skipped_rows = uint32_t{1} << 16;

  SurfaceDecoder() = default;
  SurfaceDecoder(const SurfaceDecoder&) = delete;
  SurfaceDecoder& operator=(const SurfaceDecoder&) = delete;

  /// Prepares to receive a stream. memory: for a stream of slices at least minimum_surface_bytes()
  /// for the size in the header; more memory means fewer loose fragments. Pass {} for a
  /// stream of regions, or while the size is unknown: see give_memory(). Owner: the caller, while
  /// the decoder is in use. channel: the channel of the surface; any_channel: the first surface of
  /// the first stream that arrives. Errors: bad_sink (no function).
  [[nodiscard]] Status start(Memory memory, const Sink& sink, uint8_t channel = any_channel);

  /// As Decoder::set_packet_passthrough(), for streams of regions.
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    regions_.set_packet_passthrough(sink);
  }

  /// Decodes bytes, any number at a time. Status::suspended: the sink is busy, or more than
  /// max_skipped_rows lost rows are to be skipped; call push() again with the remaining bytes, even
  /// if there are none. Errors: not_started; bad_sink (the sink answered not_started);
  /// wrong_version (no byte is accepted until start()); too_little_memory (call give_memory(), then
  /// push the remaining bytes).
  Decoded push(const uint8_t* bytes, size_t count);

  /// After too_little_memory: continues with this memory, at least minimum_surface_bytes() for the
  /// size in the header. Does nothing at any other time. Owner: as of start(). Errors: not_started,
  /// too_little_memory, wrong_version.
  [[nodiscard]] Status give_memory(Memory memory);

  /// Ends the input: an unfinished region or fragment is reported as lost. Without a trailer, a
  /// stream of slices produces no `finish` event. Status::suspended: call finish() again. Errors:
  /// as push().
  [[nodiscard]] Status finish();

  const StreamHeader& header() const { return regions_.header(); }
  const StreamReport& report() const {
    return is_of_slices_ ? slices_.report() : regions_.report();
  }

 private:
  Decoded push_to_both(const uint8_t* byte);
  Status begin_sweep();
  uint8_t wanted_channel() const { return channel_ == any_channel ? header().channel : channel_; }
  SinkResult take(const RowEvent& event);
  SinkResult begin(const StreamHeader& all);
  SinkResult pass(const Event& event) { return sink_.take(sink_.context, event); }
  SinkResult skip(uint64_t rows, Substitute substitute);
  SinkResult end(bool is_abandoned);

  Sink sink_;
  uint8_t channel_ = any_channel;
  Memory memory_;
  Decoder regions_;
  SliceDecoder slices_;
  Extractor32 extractor_;
  Status refusal_ = Status::ok;  // of a stream of slices
  bool is_known_ = false;        // the kind of the stream
  bool is_of_slices_ = false;
  uint64_t skipped_rows_ = 0;  // of the rows lost together
};

}  // namespace discmc

#endif
