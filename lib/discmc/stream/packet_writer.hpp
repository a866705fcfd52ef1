// Writes packets: numbers, protects and frames them, and passes them to the output. It makes
// headers and trailers; the encoders write the payload of other packets.
#ifndef DISCMC_STREAM_PACKET_WRITER_HPP
#define DISCMC_STREAM_PACKET_WRITER_HPP

#include <discmc/byte_output.hpp>
#include <discmc/stream/records_packet.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc::detail::stream {

/// Holds one packet: open while its payload is written, sealed while its frame is sent.
class PacketWriter {
 public:
  /// Sets the output, without a stream. Limit: the output has a function.
  void attach(const ByteOutput& output);
  /// Begins a stream by sealing header(). flags: the detail::wire::HeaderFlags that do not follow
  /// from it. If a part of a frame was sent before, a zero byte first ends that frame.
  /// Limit: is_open().
  void begin_stream(uint8_t flags);
  bool has_output() const { return output_.write != nullptr; }
  /// The header of the current stream, or of the previous one.
  StreamHeader& header() { return header_; }
  const StreamHeader& header() const { return header_; }

  /// Whether the packet is open.
  bool is_open() const { return frame_bytes_ == 0; }
  /// The payload of an open packet: room for detail::wire::max_payload bytes. Regions, fragments
  /// and slices use at most max_payload() of them.
  uint8_t* payload() { return frame_ + 1 + detail::wire::packet_head; }
  size_t max_payload() const {
    const size_t frame = output_.max_frame == 0 ? detail::wire::max_frame : output_.max_frame;
    return frame - (detail::wire::max_frame - detail::wire::max_payload);
  }
  /// Seals the open packet, whose payload ends at `end`.
  void seal(detail::wire::PacketKind kind, uint8_t* end);
  /// Seals a trailer made of the event that ends the scan. Limit: the packet is open.
  void seal_trailer(const Event& finish);
  /// Seals a trailer for a stream of slices.
  void seal_slices_trailer(uint32_t slices, bool is_abandoned, uint64_t rows,
                           uint64_t skipped_rows);
  /// Seals an application record. kind: one of the two for application records. Limit: the packet
  /// is open, and the record not too long.
  void seal_application(detail::wire::PacketKind kind, const ApplicationRecord& record);
  /// Seals a copy of a packet. Limit: the packet is open, the copy at most
  /// detail::wire::max_payload or max_whole_regions long, and its pieces fit into 16 bits.
  void seal_appended(const RecordsPacket& packet);
  /// Sends the sealed frame. True if all of it was sent: then the next packet is open.
  bool drain();

  /// Counts a complete piece, in the open packet or before it.
  void count_piece() { ++pieces_; }
  /// The bytes that the output has accepted so far.
  uint64_t bytes() const { return bytes_; }

  /// Whether a checkpoint is complete: ok if every accepted byte has left the output, suspended if
  /// not yet, bad_sink if the output cannot report this.
  Status ready_for_checkpoint() const;
  /// After a checkpoint: continues at the beginning of the frame, on this output. Limit: the output
  /// has a function.
  void resume(const ByteOutput& output);
  /// Sets another output. Without a function, bytes are only counted.
  void set_output(const ByteOutput& output);
  /// Repeats the header, for a receiver that joins late: at once if the open packet is empty,
  /// otherwise after it. Does nothing after a trailer.
  void repeat_header(bool is_packet_empty);

 private:
  void seal_header();
  void put_delimiter();

  // Small members come first, because short instructions reach them there.
  bool is_under_way_ = false;  // whether its header was sealed, and its trailer was not
  uint8_t packets_since_header_ = 0;
  uint8_t flags_ = 0;
  bool is_cut_ = false;       // whether a part of a frame was sent, and nothing since
  uint16_t frame_bytes_ = 0;  // of a sealed frame; 0 while a packet is open
  uint16_t drained_ = 0;
  ByteOutput output_;
  uint32_t packets_ = 0;
  uint32_t digest_ = 0;
  uint32_t pieces_before_ = 0;  // complete pieces before the open packet, modulo 2^32
  uint64_t pieces_ = 0;         // regions and fragments so far
  uint64_t bytes_ = 0;
  StreamHeader header_ = detail::wire::no_header();
  uint8_t frame_[detail::wire::max_frame] = {};
};

}  // namespace discmc::detail::stream

#endif
