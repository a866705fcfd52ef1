#include <discmc/stream/crc32.hpp>
#include <discmc/stream/packet_reader.hpp>

namespace discmc {

void PacketReader::start(uint8_t channel) {
  channel_ = channel;
  has_tag_ = false;
  digest_ = 0;
  header_ = StreamHeader{};
  report_ = StreamReport{};
  is_refused_ = false;
  gap_is_untold_ = false;
  gap_is_noted_ = true;
  pieces_passed_ = 0;
  frame_bytes_ = 0;
}

PacketReader::Arrival PacketReader::take(uint8_t byte) {
  ++report_.bytes;
  if (byte != 0) {
    if (frame_bytes_ < sizeof(frame_)) frame_[frame_bytes_++] = byte;
    return Arrival::nothing;
  }
  const size_t bytes = frame_bytes_;
  frame_bytes_ = 0;
  return bytes == 0 ? Arrival::nothing : open_frame(bytes);  // a spare delimiter is no frame
}

void PacketReader::finish() {
  if (frame_bytes_ > 0) damage();
  frame_bytes_ = 0;
  gap_is_untold_ = true;
}

bool PacketReader::take_gap() {
  const bool was_untold = gap_is_untold_;
  gap_is_untold_ = false;
  return was_untold;
}

void PacketReader::note_unreadable() {
  damage();
  report_.is_unreadable = true;
}

PacketReader::Arrival PacketReader::damage() {
  ++report_.damaged_packets;
  return Arrival::nothing;
}

PacketReader::Arrival PacketReader::open_frame(size_t bytes) {
  using namespace wire;
  const size_t plain = cobs::unstuff(frame_, bytes);
  const uint8_t* const packet = frame_ + 1;
  if (plain < packet_head + packet_tail || plain > max_packet) return damage();
  const size_t checked = plain - packet_crc;
  const uint32_t crc = crc32(packet, checked);
  if (crc != ByteReader(packet + checked, packet_crc).get(4)) return damage();
  payload_bytes_ = checked - packet_tag - packet_head;
  const PacketKind kind = static_cast<PacketKind>(packet[0]);
  if (!is_ours(static_cast<uint32_t>(ByteReader(packet + checked - packet_tag, 3).get(3)))) {
    ++report_.foreign_packets;
    return Arrival::nothing;
  }
  if (report_.has_trailer) {
    ++report_.repeated_packets;
    return Arrival::nothing;
  }
  if (kind == PacketKind::header && !read_header()) return Arrival::nothing;
  if (!is_expected(packet)) return Arrival::nothing;
  ++report_.packets;
  const bool is_trailer = kind == PacketKind::trailer || kind == PacketKind::slices_trailer;
  if (!is_trailer) digest_ = digest_with(digest_, crc);
  if (kind == PacketKind::trailer) return read_trailer();
  if (kind == PacketKind::slices_trailer) return read_slices_trailer();
  if (kind == PacketKind::application || kind == PacketKind::slices_application)
    return payload_bytes_ < application_head ? damage() : Arrival::application;
  if (is_of_slices(packet[0])) return Arrival::slices;
  if (kind == PacketKind::whole_regions) {
    if (payload_bytes_ < whole_regions_tail) return damage();
    payload_bytes_ -= whole_regions_tail;
    return Arrival::records;
  }
  return kind == PacketKind::records ? Arrival::records : Arrival::nothing;
}

uint32_t PacketReader::whole_regions() const {
  if (frame_[1] != static_cast<uint8_t>(wire::PacketKind::whole_regions)) return 0;
  wire::ByteReader tail(payload() + payload_bytes_, wire::whole_regions_tail);
  return static_cast<uint32_t>(tail.get(wire::whole_regions_tail));
}

ApplicationRecord PacketReader::application() const {
  wire::ByteReader reader(payload(), payload_bytes_);
  ApplicationRecord record;
  record.kind = static_cast<uint8_t>(reader.get(1));
  record.slice = static_cast<uint32_t>(reader.get(4));
  record.row = static_cast<uint32_t>(reader.get(4));
  record.bytes = payload() + wire::application_head;
  record.count = payload_bytes_ - wire::application_head;
  return record;
}

// The first packet of the channel says which scan it is.
bool PacketReader::is_ours(uint32_t tag) {
  if (!has_tag_) {
    const uint32_t first = wire::channel_in(tag);
    const bool holds_channel =
        channel_ >= first && channel_ <= first + wire::further_surfaces_in(tag);
    if (channel_ != any_channel && !holds_channel) return false;
    tag_ = tag;
    has_tag_ = true;
  }
  return tag == tag_;
}

// Whether a packet is the next one or a later one; a gap before it is noted. Half of the counts of
// pieces, and where these say nothing half of the numbers, lie behind.
bool PacketReader::is_expected(const uint8_t* packet) {
  if (wire::is_of_slices(packet[0])) return is_expected_by_number(packet);
  const uint8_t number = packet[1];
  const uint32_t low = uint32_t{packet[2]} | uint32_t{packet[3]} << 8;
  const uint16_t pieces = static_cast<uint16_t>(low - pieces_passed_);
  const uint8_t gap = static_cast<uint8_t>(number - packets_passed());
  const bool is_trailer = packet[0] == static_cast<uint8_t>(wire::PacketKind::trailer);
  if (packets_passed() > 0 && !is_trailer && (pieces >= 0x8000 || (pieces == 0 && gap >= 128))) {
    ++report_.repeated_packets;
    return false;
  }
  note_gap(gap, is_trailer ? 0 : pieces);  // a trailer tells of pieces in full
  return true;
}

// Those of slices tell more of their number instead.
bool PacketReader::is_expected_by_number(const uint8_t* packet) {
  constexpr uint32_t numbers = uint32_t{1} << 24;
  const auto number = static_cast<uint32_t>(wire::ByteReader(packet + 1, 3).get(3));
  const uint32_t gap = (number - static_cast<uint32_t>(packets_passed())) % numbers;
  if (gap >= numbers / 2) {
    ++report_.repeated_packets;
    return false;
  }
  note_gap(gap, 0);
  return true;
}

void PacketReader::note_gap(uint64_t packets, uint64_t pieces) {
  if (packets == 0 && pieces == 0) return;
  gap_is_noted_ = true;
  gap_is_untold_ = true;
  report_.lost_packets += packets;
  report_.lost_pieces += pieces;
  pieces_passed_ += pieces;
}

// The header's own counts are whole numbers: they set right what the short ones could not tell.
// False when nothing more is to be had of the packet.
bool PacketReader::read_header() {
  wire::ByteReader reader(payload(), payload_bytes_);
  const bool is_ours = reader.get(3) == wire::magic;
  is_refused_ = is_ours && reader.get(1) != wire::version;
  if (is_refused_) return false;
  StreamHeader header;
  header.width = static_cast<uint32_t>(reader.get(2));
  header.height = static_cast<uint32_t>(reader.get(2));
  header.depth = static_cast<uint32_t>(reader.get(4));
  for (int32_t& spacing : header.spacing_nm)
    spacing = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  header.threshold = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  const uint64_t flags = reader.get(1);
  header.border = (flags & wire::HeaderFlags::open_border) != 0 ? Border::open : Border::closed;
  const uint64_t packets_before = reader.get(4);
  const uint64_t pieces_before = reader.get(8);
  header.scan = static_cast<uint16_t>(tag_);
  header.channel = wire::channel_in(tag_);
  header.further_surfaces = wire::further_surfaces_in(tag_);
  for (int32_t& threshold : header.further_thresholds)
    threshold = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  if (!is_ours || payload_bytes_ < wire::header_payload || !header.is_valid()) {
    damage();
    return false;
  }
  if (!report_.has_header) {
    header_ = header;
    report_.holds_slices = (flags & wire::HeaderFlags::slices) != 0;
  }
  report_.has_header = true;
  if (packets_before < packets_passed()) {
    ++report_.repeated_packets;
    return false;
  }
  const uint64_t packets_missing = packets_before - packets_passed();
  const uint64_t pieces = pieces_before > pieces_passed_ ? pieces_before - pieces_passed_ : 0;
  // A gap noted too small, by whole rounds of the short number, was before what is open. The
  // number that packets of slices tell is not so short.
  const bool may_be_noted = gap_is_noted_ && !report_.holds_slices;
  const bool is_gap_here =
      packets_missing % 256 != 0 || pieces > 0 || (packets_missing > 0 && !may_be_noted);
  report_.lost_packets += packets_missing;
  if (is_gap_here) {
    note_gap(0, pieces);
    gap_is_untold_ = true;
  }
  gap_is_noted_ = false;
  return true;
}

// What both kinds of trailer begin with.
void PacketReader::note_end(wire::ByteReader& reader) {
  report_.has_trailer = true;
  report_.slices = static_cast<uint32_t>(reader.get(4));
  report_.abandoned = reader.get(1) != 0;
}

// Where packets are missing it says nothing.
void PacketReader::compare_digest(uint32_t told) {
  report_.is_mixed = report_.lost_packets == 0 && told != digest_;
}

PacketReader::Arrival PacketReader::read_trailer() {
  if (payload_bytes_ < wire::trailer_payload) return damage();
  wire::ByteReader reader(payload(), payload_bytes_);
  note_end(reader);
  Statistics& totals = report_.totals;
  for (const auto total : wire::trailer_totals) totals.*total = reader.get(8);
  compare_digest(static_cast<uint32_t>(reader.get(4)));
  const uint64_t pieces = totals.regions + totals.fragments;
  if (pieces > pieces_passed_) note_gap(0, pieces - pieces_passed_);
  return Arrival::trailer;
}

PacketReader::Arrival PacketReader::read_slices_trailer() {
  if (payload_bytes_ < wire::slices_trailer_payload) return damage();
  wire::ByteReader reader(payload(), payload_bytes_);
  note_end(reader);
  report_.total_rows = reader.get(8);
  report_.totals.skipped_rows = reader.get(8);
  compare_digest(static_cast<uint32_t>(reader.get(4)));
  return Arrival::trailer;
}

}  // namespace discmc
