#include "packet_reader.hpp"

namespace discmc::host::version1 {

PacketReader::Arrival PacketReader::take(std::uint8_t byte) {
  ++report_.bytes;
  const Unframer::Found found = unframer_.take(byte);
  if (found == Unframer::Found::packet) return open(unframer_.packet());
  if (found == Unframer::Found::damage) ++report_.damaged_packets;
  return Arrival::nothing;
}

void PacketReader::finish() {
  if (unframer_.is_within_frame()) ++report_.damaged_packets;
  unframer_ = Unframer();
  gap_is_untold_ = true;
}

bool PacketReader::take_gap() {
  const bool was_untold = gap_is_untold_;
  gap_is_untold_ = false;
  return was_untold;
}

void PacketReader::pass_region() {
  ++report_.regions;
  ++regions_passed_;
}

void PacketReader::lose_region() {
  ++report_.lost_pieces;
  ++regions_passed_;
}

void PacketReader::note_unreadable() {
  ++report_.damaged_packets;
  report_.is_unreadable = true;
}

PacketReader::Arrival PacketReader::open(const Packet& packet) {
  if (report_.has_trailer) {
    ++report_.repeated_packets;
    return Arrival::nothing;
  }
  if (packet.kind == PacketKind::header && !take_header(packet)) return Arrival::nothing;
  if (!is_expected(packet)) return Arrival::nothing;
  ++report_.packets;
  if (packet.kind == PacketKind::trailer) return take_trailer(packet);
  return packet.kind == PacketKind::records ? Arrival::records : Arrival::nothing;
}

// Whether a packet is the next one or a later one; a gap before it is noted. Half of the counts of
// regions, and where these say nothing half of the numbers, lie behind.
bool PacketReader::is_expected(const Packet& packet) {
  const auto regions = static_cast<std::uint16_t>(packet.regions - regions_passed_);
  const auto gap = static_cast<std::uint8_t>(packet.number - packets_passed());
  const bool is_trailer = packet.kind == PacketKind::trailer;
  if (packets_passed() > 0 && !is_trailer && (regions >= 0x8000 || (regions == 0 && gap >= 128))) {
    ++report_.repeated_packets;
    return false;
  }
  note_gap(gap, is_trailer ? 0 : regions);  // a trailer tells of regions in full
  return true;
}

void PacketReader::note_gap(std::uint64_t packets, std::uint64_t regions) {
  if (packets == 0 && regions == 0) return;
  gap_is_noted_ = true;
  gap_is_untold_ = true;
  report_.lost_packets += packets;
  report_.lost_pieces += regions;
  regions_passed_ += regions;
}

// The header's own counts are whole numbers: they set right what the short ones could not tell.
// False when nothing more is to be had of the packet.
bool PacketReader::take_header(const Packet& packet) {
  const ReadHeader read = read_header(packet);
  is_refused_ = read.is_header && !read.is_known;
  if (is_refused_) return false;
  if (!read.is_valid) {
    ++report_.damaged_packets;
    return false;
  }
  if (!report_.has_header) header_ = read.header;
  report_.has_header = true;
  if (read.packets < packets_passed()) {
    ++report_.repeated_packets;
    return false;
  }
  const std::uint64_t packets = read.packets - packets_passed();
  const std::uint64_t regions = read.regions > regions_passed_ ? read.regions - regions_passed_ : 0;
  // A gap noted too small, by whole rounds of the short number, was before what is open.
  const bool is_gap_here = packets % 256 != 0 || regions > 0 || (packets > 0 && !gap_is_noted_);
  report_.lost_packets += packets;
  if (is_gap_here) {
    note_gap(0, regions);
    gap_is_untold_ = true;
  }
  gap_is_noted_ = false;
  return true;
}

PacketReader::Arrival PacketReader::take_trailer(const Packet& packet) {
  constexpr std::uint64_t Statistics::*totals[] = {
      &Statistics::cells,   &Statistics::facets, &Statistics::classic_triangles,
      &Statistics::regions, &Statistics::rings,  &Statistics::links};
  constexpr std::size_t trailer_bytes = 4 + 1 + 9 * 8;
  if (packet.payload_bytes < trailer_bytes) {
    ++report_.damaged_packets;
    return Arrival::nothing;
  }
  wire::ByteReader reader(packet.payload, packet.payload_bytes);
  report_.has_trailer = true;
  report_.slices = static_cast<std::uint32_t>(reader.get(4));
  report_.abandoned = reader.get(1) != 0;
  for (const auto total : totals) report_.totals.*total = reader.get(8);
  reader.get(8);  // links made boundary for lack of memory
  report_.totals.fragments = reader.get(8);
  report_.totals.skipped_rows = reader.get(8);
  if (report_.totals.regions > regions_passed_)
    note_gap(0, report_.totals.regions - regions_passed_);
  gap_is_untold_ = true;
  return Arrival::trailer;
}

}  // namespace discmc::host::version1
