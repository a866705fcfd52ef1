// The stream (.dmc): packets, their header and trailer. WIRE.md explains every byte.
#ifndef DISCMC_STREAM_WIRE_HPP
#define DISCMC_STREAM_WIRE_HPP

#include <discmc/sink.hpp>
#include <discmc/stream/cobs.hpp>

namespace discmc {

namespace detail::wire {

constexpr uint8_t version = 1;

/// The kind of a packet. Readers skip packets of unknown kinds, so a better coding of regions can
/// be a new kind. Packets of slices have `slices` plus their SliceBits.
enum class PacketKind : uint8_t {
  header = 1,
  records = 2,
  trailer = 3,
  slices_trailer = 4,
  application = 5,
  slices_application = 6,
  whole_regions = 7,
  slices = 16
};

/// The role of a packet of slices in its code, which may continue through several packets.
struct SliceBits {
  static constexpr uint8_t key = 1;    ///< begins a key slice, which needs nothing before
  static constexpr uint8_t first = 2;  ///< begins the code
  static constexpr uint8_t last = 4;   ///< ends the code
  static constexpr uint8_t cut = 8;    ///< ends the code within a row
  static constexpr uint8_t all = 15;
};
constexpr bool is_of_slices(uint8_t kind) {
  constexpr auto slices = static_cast<uint8_t>(PacketKind::slices);
  return kind / slices == 1 || kind == static_cast<uint8_t>(PacketKind::slices_trailer) ||
         kind == static_cast<uint8_t>(PacketKind::slices_application);
}
/// A payload that begins a key slice starts with the number of the slice. A payload that is cut
/// ends with the number of rows before, modulo 2^32, and the number of voxels left in the row. A
/// cut in fractions is like a cut in voxels: see FractionCode::part(). Units: bytes.
constexpr int key_slice_head = 4;
constexpr int cut_tail = 4 + 2;
constexpr uint32_t row_part = uint32_t{1} << 24;

// A packet before stuffing, in bytes:
//
//   1   kind
//   1   number modulo 256
//   2   complete pieces (regions and fragments) before it, modulo 65,536; for slices two more bytes
//       of the number
//   n   payload
//   3   scan and channel, after the payload: so the version in a header has the same position in
//       every version of the stream
//   4   CRC-32 of all bytes before
constexpr size_t packet_head = 4;
constexpr size_t packet_tag = 2 + 1;
constexpr size_t packet_crc = 4;
constexpr size_t packet_tail = packet_tag + packet_crc;
constexpr size_t max_packet = detail::cobs::max_plain;
constexpr size_t max_payload = max_packet - packet_head - packet_tail;

/// The name of a stream: its scan, the channel of its first surface, and in the upper two bits the
/// number of further surfaces.
constexpr uint32_t tag_of(const StreamHeader& header) {
  return header.scan | uint32_t{header.channel} << 16 | (header.surface_count - 1U) << 22;
}
/// The header before any stream, all zero so that a static encoder needs no flash.
constexpr StreamHeader no_header() {
  return {0, 0, 0, {}, {}, Border::closed, 0, 0, 0, 0};
}

constexpr uint8_t channel_in(uint32_t tag) {
  return static_cast<uint8_t>(tag >> 16 & StreamLabel::max_channel);
}
constexpr uint8_t surface_count_in(uint32_t tag) {
  return static_cast<uint8_t>(1 + (tag >> 22));
}

/// A packet of whole regions ends with their number. Units: bytes.
constexpr size_t whole_regions_tail = 2;
constexpr size_t max_whole_regions = max_payload - whole_regions_tail;

/// A frame is a packet with its code byte and its final zero byte.
constexpr size_t max_frame = max_packet + 2;

/// The header is repeated after this many packets of records, so that a receiver can join late.
constexpr uint32_t header_interval = 64;

constexpr uint32_t magic = 'D' | 'M' << 8 | 'C' << 16;

/// Writes a little-endian field. Returns the position after it. Limit: the buffer has room.
inline uint8_t* put(uint8_t* target, uint32_t value, int bytes) {
  for (; bytes > 0; --bytes, value >>= 8) *target++ = static_cast<uint8_t>(value);
  return target;
}

inline uint8_t* put_long(uint8_t* target, uint64_t value) {
  target = put(target, static_cast<uint32_t>(value), 4);
  return put(target, static_cast<uint32_t>(value >> 32), 4);
}

/// Reads little-endian fields; after the end, zeros.
class ByteReader {
 public:
  ByteReader(const uint8_t* bytes, size_t count) : bytes_(bytes), left_(count) {}
  uint64_t get(int bytes) {
    uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= uint64_t{next()} << 8 * i;
    return value;
  }

 private:
  uint8_t next() {
    if (left_ == 0) return 0;
    --left_;
    return *bytes_++;
  }
  const uint8_t* bytes_;
  size_t left_;
};

/// Bits of the header's flags.
struct HeaderFlags {
  static constexpr uint8_t open_border = 1;
  static constexpr uint8_t slices = 2;   ///< the packets contain slices, not regions
  static constexpr uint8_t levels = 12;  ///< twice the levels of their fractions: 0, 4 or 8
};

/// An application record: kind, slice, row, and its bytes.
constexpr size_t application_head = 1 + 4 + 4;
static_assert(application_head + ApplicationRecord::max_bytes <= max_payload, "it fits");

constexpr size_t header_payload = 3 + 1 + 2 + 2 + 4 + 3 * 4 + 4 + 1 + 4 + 8;
static_assert(header_payload + 4 * (StreamHeader::max_surfaces - 1) < max_payload,
              "a header has room for the zero byte before it");
static_assert(max_frame <= UINT16_MAX, "16 bits count the bytes of a frame");

/// The totals of the trailer, in their order. A reader must read all of them.
constexpr uint64_t Statistics::*trailer_totals[] = {
    &Statistics::cells,     &Statistics::facets,      &Statistics::classic_triangles,
    &Statistics::regions,   &Statistics::rings,       &Statistics::links,
    &Statistics::fragments, &Statistics::skipped_rows};
constexpr size_t trailer_payload = 4 + 1 + sizeof(Statistics) + 4;
static_assert(sizeof(Statistics) == 8 * sizeof(uint64_t), "the trailer holds every total");
constexpr size_t slices_trailer_payload = 4 + 1 + 8 + 8 + 4;
static_assert(trailer_payload <= max_payload && slices_trailer_payload <= max_payload, "they fit");

/// The digest of a stream with one more packet, which has this checksum. A trailer contains the
/// digest of all packets before it, so a packet of another stream with the same name is detected.
constexpr uint32_t digest_with(uint32_t digest, uint32_t crc) {
  return (digest << 1 | digest >> 31) ^ crc;
}

}  // namespace detail::wire

}  // namespace discmc

#endif
