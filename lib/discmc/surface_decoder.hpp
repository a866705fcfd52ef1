// The surface decoder: bytes of a stream in, whatever it holds, the events of the scan out.
//
// A stream of regions it decodes. One of bits it sweeps, as the device would have done: the events
// are those of an extractor that is given the same rows, skipped ones and all. Rows that were lost
// on the way are skipped rows: so the surface is closed, and the loss is told where it is.
//
// Of several surfaces of one stream it takes one. For all of them have a decoder for each channel,
// give all bytes to all of them, and each of them all the memory: the rows of the first surface are
// needed to read those of the others. For scan after scan see decoder.hpp; examples/link.cpp has
// both.
#ifndef DISCMC_SURFACE_DECODER_HPP
#define DISCMC_SURFACE_DECODER_HPP

#include <discmc/extractor.hpp>
#include <discmc/slice_decoder.hpp>

namespace discmc {

/// The least memory for streams of slices of this size, with so many surfaces. More makes regions
/// of loose fragments, at 16 bytes a slot, as more memory of an Extractor32 does: for slices of
/// 256x256 this is 29,838 bytes; with 64 KiB two thirds of the regions of a CT head come whole,
/// with 128 KiB 99 %, with 176 KiB all. A Joiner joins the others. Limit: valid limits.
constexpr uint64_t minimum_surface_bytes(const Limits& limits, uint32_t surfaces = 1) {
  return slice_decoder_bytes(limits, surfaces) + minimum_bytes<uint32_t>(limits);
}

/// Reads one stream of either kind, and hands the events of one of its surfaces to a Sink. It
/// points into itself, so it is neither copied nor moved.
class SurfaceDecoder {
 public:
  /// A call skips at most so many lost rows, as a hostile stream can claim any number of them.
  static constexpr uint32_t max_skipped_rows = uint32_t{1} << 16;

  SurfaceDecoder() = default;
  SurfaceDecoder(const SurfaceDecoder&) = delete;
  SurfaceDecoder& operator=(const SurfaceDecoder&) = delete;

  /// Begins a stream. memory: none for streams of regions, or before it is known; at least
  /// minimum_surface_bytes() for the size that the header of a stream of slices will tell, and more
  /// for fewer loose fragments (see there); Owner: the caller, as long as the decoder is used.
  /// channel: as of the Decoder; of several surfaces of one stream that one, or the first. Errors:
  /// bad_sink.
  [[nodiscard]] Status start(Memory memory, const Sink& sink, uint8_t channel = any_channel);

  /// As of the Decoder.
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    regions_.set_packet_passthrough(sink);
  }

  /// As Decoder::push(). Status::suspended: also that there are more lost rows to skip. Errors:
  /// also too_little_memory, as of SliceDecoder::push().
  Decoded push(const uint8_t* bytes, size_t count);

  /// As SliceDecoder::give_memory(), with minimum_surface_bytes() or more.
  [[nodiscard]] Status give_memory(Memory memory);

  /// As Decoder::finish(); errors as push(). Of a stream of slices that has no end the surface has
  /// none either.
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
  bool is_known_ = false;        // what the stream holds
  bool is_of_slices_ = false;
  uint64_t skipped_rows_ = 0;  // of those that were lost together
};

}  // namespace discmc

#endif
