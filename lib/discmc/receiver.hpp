// The receiver: the bytes of a link in, events of one surface out, scan after scan.
//
//   start(memory, sink, channel)
//   push(bytes, count)       as bytes arrive, any number at a time
//   resume()                 after Status::suspended, when the sink is ready again
//   finish()                 after the last byte, if the link ends
//
// From a stream of regions it decodes the events of the scan. It extracts the surface from a stream
// of slices, as the device would have done. The events are those of an extractor for the same rows,
// including skipped ones. Rows lost in transit count as skipped rows that are off. So a closed
// border still has a closed surface, and `skipped` events locate the loss.
//
// Any bytes are safe: a receiver never reads beyond its input, never writes beyond its object and
// its memory, and allocates nothing. It delivers one surface. If a link has several, use one
// receiver per channel, and push all bytes to each; examples/link.cpp does so.
#ifndef DISCMC_RECEIVER_HPP
#define DISCMC_RECEIVER_HPP

#include <discmc/slices/surface_decoder.hpp>

namespace discmc {

/// Receives the scans of one channel. A receiver contains pointers to itself, so it is neither
/// copied nor moved.
class Receiver {
 public:
  /// The most lost rows that one call skips, because a hostile stream can claim any number of them.
  static constexpr uint32_t max_skipped_rows = SurfaceDecoder::max_skipped_rows;

  /// The least memory for streams of slices of this size with this many surfaces: 29,766 bytes for
  /// one surface of 256x256. More memory becomes slots of 16 bytes each, as in an Extractor32, so
  /// that fewer regions arrive as loose fragments. For CT head (Stanford), 128 KiB suffice for 99 %
  /// of the regions, and 176 KiB for all. A Joiner joins the rest. Limit: valid limits.
  static constexpr uint64_t minimum_bytes(const Limits& limits, uint32_t surfaces = 1,
                                          uint32_t levels = 0) {
    return SurfaceDecoder::minimum_bytes(limits, surfaces, levels);
  }

  /// Prepares to receive. memory: for streams of slices at least minimum_bytes() for the size in
  /// the header, with all surfaces of the stream. Pass {} for streams of regions, or while the size
  /// is unknown: see set_memory(). Owner: the caller, while the receiver is in use. channel: 0 to
  /// 63; any_channel: the channel of the first packet, for all scans. Errors: bad_sink (no
  /// function), bad_label (another channel).
  [[nodiscard]] Status start(Memory memory, const Sink& sink, uint8_t channel = any_channel);

  /// Sends packets of whole regions (see RecordsPacket) to this sink, instead of the events of
  /// their regions. The packets come after the `start` event, between two regions or fragments.
  /// start() removes the sink, so call this function after start().
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    decoder_.set_packet_passthrough(sink);
  }

  /// Decodes bytes, any number at a time, and sends the events that they complete. A packet before
  /// the first header of a stream of regions is decoded, too; then `start` comes late.
  ///
  /// Status::finished: a scan is over. report() and header() describe it until the next push();
  /// push the remaining bytes, which begin the next scan. A scan is over after its trailer. If its
  /// trailer is lost, it is over when a packet with another scan number arrives, and has no
  /// `finish` event. Packets of a scan that is over, such as those that a device repeats after a
  /// power failure, are ignored until a stream begins anew.
  ///
  /// Status::suspended: the sink is busy, or more than max_skipped_rows lost rows are to be
  /// skipped. Errors: not_started; bad_sink (the sink has not started); wrong_version (no byte is
  /// accepted until start()); too_little_memory (call set_memory(), then push the remaining
  /// bytes).
  Decoded push(const uint8_t* bytes, size_t count);

  /// Continues after Status::suspended, as push() without bytes.
  [[nodiscard]] Status resume() { return push(nullptr, 0).status; }

  /// After too_little_memory: continues with this memory, at least minimum_bytes() for the size in
  /// the header. Does nothing at any other time. Owner: as of start(). Errors: not_started,
  /// too_little_memory, wrong_version.
  [[nodiscard]] Status set_memory(Memory memory) { return decoder_.set_memory(memory); }

  /// Ends the input: an unfinished region or fragment is reported as lost. Without a trailer there
  /// is no `finish` event. Status::suspended: call finish() again. Errors: as push().
  [[nodiscard]] Status finish();

  /// The header of the scan; all zero until report().has_header.
  const StreamHeader& header() const { return decoder_.header(); }
  /// What has arrived of the scan, and what is missing.
  const StreamReport& report() const { return decoder_.report(); }

 private:
  bool is_at_end() const { return report().has_trailer || decoder_.holds_next_scan(); }

  SurfaceDecoder decoder_;
  bool is_over_ = false;  // the scan of the report
};

}  // namespace discmc

#endif
