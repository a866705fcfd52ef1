// Reads packets: undoes and checks frames, compares numbers, and counts losses. It reads headers
// and trailers; the decoders read the payload of other packets.
// Any bytes are safe. The reader never reads beyond its input, nor writes beyond its own object.
#ifndef DISCMC_STREAM_PACKET_READER_HPP
#define DISCMC_STREAM_PACKET_READER_HPP

#include <discmc/stream/wire.hpp>
#include <discmc/stream_report.hpp>

namespace discmc::detail::stream {

class PacketReader {
 public:
  /// Begins a stream: the one of the first undamaged packet on this channel.
  void start(uint8_t channel);

  /// The item that the last byte completed.
  enum class Completed : uint8_t { nothing, records, slices, application, trailer };
  /// Reads a byte. Limit: not is_refused(), and the decoder has processed the packet before.
  Completed add(uint8_t byte);
  /// Ends the input.
  void finish();

  /// Whether the packet that arrived last is the first one of the next scan on this channel. It is
  /// kept until the next byte.
  bool holds_next_scan() const { return kept_bytes_ > 0; }
  /// Begins the next scan on the channel of the reader `before`, which may be this one, with the
  /// packet that it holds. Packets of the scan before count as foreign.
  Completed start_next(const PacketReader& before);

  /// Whether anything before the current packet, or at the end, is lost. Returns true once per
  /// loss.
  bool remove_gap();
  /// Whether a header has another version; then nothing more is read.
  bool is_refused() const { return is_refused_; }

  /// The SliceBits of the current packet of slices.
  uint8_t slice_bits() const { return frame_[1] & detail::wire::SliceBits::all; }
  /// The current application record, until the next byte.
  ApplicationRecord application() const;
  /// The payload of the current packet, until the next byte.
  const uint8_t* payload() const { return frame_ + 1 + detail::wire::packet_head; }
  uint8_t* payload() { return frame_ + 1 + detail::wire::packet_head; }
  size_t payload_bytes() const { return payload_bytes_; }

  /// The number of regions in a packet of whole regions; 0 for other packets.
  uint32_t whole_regions() const;

  /// Counts pieces that were completed or lost.
  void pass_pieces(uint32_t pieces) { pieces_passed_ += pieces; }
  /// Counts a packet with a valid checksum and an invalid payload.
  void note_unreadable();

  const StreamHeader& header() const { return header_; }
  const StreamReport& report() const { return report_; }
  StreamReport& report() { return report_; }

 private:
  Completed open_frame(size_t bytes);
  Completed open_packet(size_t bytes);
  Completed note_damaged();
  bool adopt(uint32_t tag);
  bool is_on_channel(uint32_t tag) const;
  bool accept_number(const uint8_t* packet);
  bool accept_long_number(const uint8_t* packet);
  // The number of the next packet.
  uint64_t packets_passed() const { return report_.packets + report_.lost_packets; }
  void note_gap(uint64_t packets, uint64_t pieces);
  bool read_header();
  void note_end(detail::wire::ByteReader& reader);
  void compare_digest(uint32_t expected);
  Completed read_trailer();
  Completed read_slices_trailer();

  StreamHeader header_ = detail::wire::no_header();
  StreamReport report_;
  uint8_t channel_ = any_channel;
  bool is_refused_ = false;
  bool has_tag_ = false;
  bool is_gap_due_ = false;
  bool is_gap_noted_ = true;  // since the last header; packets before the start are a gap
  bool has_ended_tag_ = false;
  uint32_t ended_tag_ = 0;      // of the previous scan
  uint32_t tag_ = 0;            // of the accepted packets: scan and channel
  uint32_t digest_ = 0;         // of the accepted packets
  uint64_t pieces_passed_ = 0;  // regions and fragments sent so far, including lost ones
  size_t payload_bytes_ = 0;
  size_t kept_bytes_ = 0;   // of a packet of the next scan, in the frame
  size_t frame_bytes_ = 0;  // bytes beyond the size of a frame are dropped
  uint8_t frame_[detail::wire::max_frame];
};

}  // namespace discmc::detail::stream

#endif
