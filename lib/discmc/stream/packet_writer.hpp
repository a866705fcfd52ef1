// Packets on their way out: numbered, protected, framed and handed to the output. Headers among
// them are made here; what the others hold is the encoders' matter.
#ifndef DISCMC_STREAM_PACKET_WRITER_HPP
#define DISCMC_STREAM_PACKET_WRITER_HPP

#include <discmc/byte_output.hpp>
#include <discmc/records_packet.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

/// One packet is held: open, while its payload is written, or sealed, while its frame goes out.
class PacketWriter {
 public:
  /// Says where packets go, and that there is no stream yet. Limit: the output has a function.
  void attach(const ByteOutput& output);
  /// Begins a stream: the header is sealed. flags: of wire::HeaderFlags, those that the header does
  /// not tell. Where a part of a frame went out before, a zero goes first, which ends that. Limit:
  /// open(), and nothing is sealed.
  void begin_stream(const StreamHeader& header, uint8_t flags);
  bool has_output() const { return output_.write != nullptr; }
  /// Of the stream that goes on, or went before.
  StreamHeader& header() { return header_; }
  const StreamHeader& header() const { return header_; }

  /// Whether the packet is open.
  bool is_open() const { return frame_bytes_ == 0; }
  /// The payload of an open packet: room for wire::max_payload bytes.
  uint8_t* payload() { return frame_ + 1 + wire::packet_head; }
  /// Seals the open packet, whose payload ends at `end`.
  void seal(wire::PacketKind kind, uint8_t* end);
  /// Seals a trailer made of the event that ends the scan. Limit: the packet is open.
  void seal_trailer(const Event& finish);
  /// The same of a scan whose slices were sent.
  void seal_slices_trailer(uint32_t slices, bool is_abandoned, uint64_t rows,
                           uint64_t skipped_rows);
  /// Seals an application record. kind: of the two for such. Limit: the packet is open, and the
  /// record not too long.
  void seal_application(wire::PacketKind kind, const ApplicationRecord& record);
  /// Seals a copy. Limit: the packet is open, the copy at most as long as its kind may be
  /// (wire::max_payload, max_whole_regions), and its pieces within 16 bits.
  void seal_appended(const RecordsPacket& packet);
  /// Hands over what is sealed. True when all of it is gone: then the next packet is open.
  bool drain();

  /// One more piece is complete, in the open packet or before it.
  void count_piece() { ++pieces_; }
  /// The bytes that the output has taken so far.
  uint64_t bytes() const { return bytes_; }

  /// For a checkpoint: as it was at the beginning of its frame, and without an output.
  void rewind();
  /// Where it goes on. Without a function: nowhere, but bytes are counted.
  void set_output(const ByteOutput& output);
  /// Sends the header again, for a receiver that comes late: now where nothing is in the open
  /// packet, else behind what is there. Nothing behind a trailer.
  void repeat_header(bool packet_is_empty);

 private:
  void seal_header();
  void put_delimiter();

  // Small members stand first, where they are reached by short instructions.
  bool is_under_way_ = false;  // a stream: its header was sealed, and its trailer was not
  uint8_t packets_since_header_ = 0;
  uint8_t flags_ = 0;
  bool is_cut_ = false;       // a part of a frame went out, and nothing since
  uint16_t frame_bytes_ = 0;  // of a sealed frame; 0 while a packet is open
  uint16_t drained_ = 0;
  ByteOutput output_;
  uint32_t packets_ = 0;
  uint32_t digest_ = 0;
  uint32_t pieces_before_ = 0;  // the open packet, modulo 2^32
  uint64_t pieces_ = 0;         // regions and fragments so far
  uint64_t bytes_ = 0;
  StreamHeader header_ = wire::no_header();
  uint8_t frame_[wire::max_frame] = {};
};

}  // namespace discmc

#endif
