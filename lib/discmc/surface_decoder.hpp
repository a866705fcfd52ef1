// The surface decoder: bytes of a stream of either kind in, events of the scan out.
//
// It decodes a stream of regions. It sweeps a stream of slices as the device would have done: the
// events are those of an extractor that receives the same rows, including skipped ones. It treats
// rows lost in transit as skipped rows, so the surface is closed and `skipped` events locate the
// loss.
//
// It delivers one of several surfaces in a stream. For all of them use one decoder per channel, and
// push all bytes to each. Give each the memory for all surfaces: decoding a further surface needs
// the rows of the first. For scan after scan see decoder.hpp; examples/link.cpp shows both.
#ifndef DISCMC_SURFACE_DECODER_HPP
#define DISCMC_SURFACE_DECODER_HPP

#include <discmc/extractor.hpp>
#include <discmc/slice_decoder.hpp>

namespace discmc {

/// The least memory for streams of slices of this size with this many surfaces. More memory makes
/// whole regions of loose fragments, at 16 bytes per slot, as in an Extractor32. For slices of
/// 256x256 the least is 29,838 bytes. With 64 KiB two thirds of the regions of a CT head arrive
/// whole, with 128 KiB 99 %, with 176 KiB all. A Joiner joins the others. Limit: valid limits.
constexpr uint64_t minimum_surface_bytes(const Limits& limits, uint32_t surfaces = 1) {
  return slice_decoder_bytes(limits, surfaces) + minimum_bytes<uint32_t>(limits);
}

/// Decodes one stream of either kind, and sends the events of one of its surfaces to a Sink. A
/// decoder contains pointers to itself, so it is neither copied nor moved.
class SurfaceDecoder {
 public:
  /// The most lost rows that a call skips, because a hostile stream can claim any number of them.
  static constexpr uint32_t max_skipped_rows = uint32_t{1} << 16;

  SurfaceDecoder() = default;
  SurfaceDecoder(const SurfaceDecoder&) = delete;
  SurfaceDecoder& operator=(const SurfaceDecoder&) = delete;

  /// Waits for a stream. memory: none for streams of regions, or while the header is unknown. For
  /// streams of slices at least minimum_surface_bytes() of the size in the header, and more for
  /// fewer loose fragments; Owner: the caller, while the decoder is in use. channel: as of the
  /// Decoder; of several surfaces the one on this channel, or the first. Errors: bad_sink.
  [[nodiscard]] Status start(Memory memory, const Sink& sink, uint8_t channel = any_channel);

  /// As of the Decoder.
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    regions_.set_packet_passthrough(sink);
  }

  /// As Decoder::push(). Status::suspended: the sink is busy, or more lost rows are to be skipped.
  /// Errors: also too_little_memory, as of SliceDecoder::push().
  Decoded push(const uint8_t* bytes, size_t count);

  /// As SliceDecoder::give_memory(), with minimum_surface_bytes() or more.
  [[nodiscard]] Status give_memory(Memory memory);

  /// As Decoder::finish(); errors as push(). Without a trailer, a stream of slices produces no
  /// `finish` event.
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
