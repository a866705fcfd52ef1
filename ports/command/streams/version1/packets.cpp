#include "packets.hpp"

#include <discmc/stream/crc32.hpp>

namespace discmc::host::version1 {

using wire::ByteReader;

Unframer::Found Unframer::take(std::uint8_t byte) {
  if (byte != 0) {
    if (bytes_ < sizeof(frame_)) frame_[bytes_++] = byte;
    return Found::nothing;
  }
  const std::size_t bytes = bytes_;
  bytes_ = 0;
  return bytes == 0 ? Found::nothing : open(bytes);  // a spare delimiter is no frame
}

Unframer::Found Unframer::open(std::size_t bytes) {
  const std::size_t plain = cobs::unstuff(frame_, bytes);
  if (plain < head_bytes + check_bytes || plain > cobs::max_plain) return Found::damage;
  const std::uint8_t* const begin = frame_ + 1;
  const std::size_t checked = plain - check_bytes;
  if (crc32(begin, checked) != ByteReader(begin + checked, check_bytes).get(4))
    return Found::damage;
  ByteReader head(begin, head_bytes);
  packet_.kind = static_cast<PacketKind>(head.get(1));
  packet_.number = static_cast<std::uint8_t>(head.get(1));
  packet_.regions = static_cast<std::uint16_t>(head.get(2));
  packet_.payload = begin + head_bytes;
  packet_.payload_bytes = checked - head_bytes;
  return Found::packet;
}

bool HeaderSearch::take(std::uint8_t byte) {
  if (unframer_.take(byte) != Unframer::Found::packet) return false;
  const Packet& packet = unframer_.packet();
  return packet.kind == PacketKind::header && read_header(packet).is_known;
}

ReadHeader read_header(const Packet& packet) {
  ByteReader reader(packet.payload, packet.payload_bytes);
  ReadHeader read;
  constexpr std::uint8_t version = 1;
  read.is_header = reader.get(3) == wire::magic;
  read.is_known = read.is_header && reader.get(1) == version;
  if (!read.is_known) return read;
  StreamHeader& header = read.header;
  header.width = static_cast<std::uint32_t>(reader.get(2));
  header.height = static_cast<std::uint32_t>(reader.get(2));
  header.depth = static_cast<std::uint32_t>(reader.get(4));
  for (std::int32_t& spacing : header.spacing_nm)
    spacing = static_cast<std::int32_t>(static_cast<std::uint32_t>(reader.get(4)));
  header.threshold = static_cast<std::int32_t>(static_cast<std::uint32_t>(reader.get(4)));
  header.border = reader.get(1) == 1 ? Border::open : Border::closed;
  read.packets = reader.get(4);
  read.regions = reader.get(8);
  const Limits limits{header.width, header.height, header.border};
  read.is_valid = packet.payload_bytes >= header_bytes && limits.is_valid();
  return read;
}

}  // namespace discmc::host::version1
