// Packets as they come in: frames are undone and checked, numbers compared, losses counted. Headers
// and trailers are read here; what the others hold is the decoders' matter.
//
// Any bytes are safe. It never reads beyond what it is given nor writes beyond its own object.
#ifndef DISCMC_STREAM_PACKET_READER_HPP
#define DISCMC_STREAM_PACKET_READER_HPP

#include <discmc/stream/wire.hpp>
#include <discmc/stream_report.hpp>

namespace discmc {

class PacketReader {
 public:
  /// Begins a stream: the one of the first whole packet of this channel.
  void start(uint8_t channel);

  /// What a byte has completed.
  enum class Completed : uint8_t { nothing, records, slices, application, trailer };
  /// Takes a byte. Limit: not is_refused(), and the decoder is done with the packet before.
  Completed take(uint8_t byte);
  /// Tells that no byte follows.
  void finish();

  /// Whether something before the packet that has arrived, or at the end, is lost; says it once.
  bool take_gap();
  /// Whether a header names a version that is not known: nothing more is read.
  bool is_refused() const { return is_refused_; }

  /// The SliceBits of the slices that have arrived.
  uint8_t slice_bits() const { return frame_[1] & wire::SliceBits::all; }
  /// The application record that has arrived, until the next byte.
  ApplicationRecord application() const;
  /// The payload of what has arrived, until the next byte.
  const uint8_t* payload() const { return frame_ + 1 + wire::packet_head; }
  uint8_t* payload() { return frame_ + 1 + wire::packet_head; }
  size_t payload_bytes() const { return payload_bytes_; }

  /// How many regions the records that have arrived say they are, if these are known to be whole;
  /// else 0.
  uint32_t whole_regions() const;

  /// Pieces that began in the packets have been completed, or lost.
  void pass_pieces(uint32_t pieces) { pieces_passed_ += pieces; }
  /// A packet, whole by its checksum, does not hold what it should.
  void note_unreadable();

  const StreamHeader& header() const { return header_; }
  const StreamReport& report() const { return report_; }
  StreamReport& report() { return report_; }

 private:
  Completed open_frame(size_t bytes);
  Completed damage();
  bool adopt(uint32_t tag);
  bool accept_number(const uint8_t* packet);
  bool accept_long_number(const uint8_t* packet);
  // What the next packet is to be numbered.
  uint64_t packets_passed() const { return report_.packets + report_.lost_packets; }
  void note_gap(uint64_t packets, uint64_t pieces);
  bool read_header();
  void note_end(wire::ByteReader& reader);
  void compare_digest(uint32_t expected);
  Completed read_trailer();
  Completed read_slices_trailer();

  StreamHeader header_ = wire::no_header();
  StreamReport report_;
  uint8_t channel_ = any_channel;
  bool is_refused_ = false;
  bool has_tag_ = false;
  bool gap_is_due_ = false;
  bool gap_is_noted_ = true;    // since the last header; what came before the start is a gap
  uint32_t tag_ = 0;            // of the packets that are taken: scan and channel
  uint32_t digest_ = 0;         // of those that have been
  uint64_t pieces_passed_ = 0;  // regions and fragments sent before now, lost ones included
  size_t payload_bytes_ = 0;
  size_t frame_bytes_ = 0;  // what is more than a frame is dropped: it is none
  uint8_t frame_[wire::max_frame];
};

}  // namespace discmc

#endif
