#include <discmc/stream/crc32.hpp>
#include <discmc/stream/packet_reader.hpp>

namespace discmc::detail::stream {

namespace {

struct HeaderPacket {
  StreamHeader header;
  uint64_t flags;
  uint64_t packets_before;
  uint64_t pieces_before;
};

// reader: after the version. Missing bytes read as 0.
HeaderPacket parse_header(detail::wire::ByteReader& reader, uint32_t tag) {
  HeaderPacket packet;
  StreamHeader& header = packet.header;
  header.width = static_cast<uint32_t>(reader.get(2));
  header.height = static_cast<uint32_t>(reader.get(2));
  header.depth = static_cast<uint32_t>(reader.get(4));
  for (int32_t& spacing : header.spacing_nm)
    spacing = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  header.thresholds[0] = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  packet.flags = reader.get(1);
  header.border =
      (packet.flags & detail::wire::HeaderFlags::open_border) != 0 ? Border::open : Border::closed;
  if ((packet.flags & detail::wire::HeaderFlags::slices) != 0)
    header.levels = static_cast<uint8_t>((packet.flags & detail::wire::HeaderFlags::levels) / 2);
  packet.packets_before = reader.get(4);
  packet.pieces_before = reader.get(8);
  header.scan = static_cast<uint16_t>(tag);
  header.channel = detail::wire::channel_in(tag);
  header.surface_count = detail::wire::surface_count_in(tag);
  for (uint32_t i = 1; i < StreamHeader::max_surfaces; ++i)
    header.thresholds[i] = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  return packet;
}

// Whether a header is the first packet of its stream.
bool begins_stream(const uint8_t* payload, size_t bytes) {
  constexpr size_t packets_before = detail::wire::header_payload - 8 - 4;
  return bytes >= detail::wire::header_payload &&
         detail::wire::ByteReader(payload + packets_before, 4).get(4) == 0;
}

}  // namespace

void PacketReader::start(uint8_t channel) {
  channel_ = channel;
  has_tag_ = false;
  has_ended_tag_ = false;
  kept_bytes_ = 0;
  digest_ = 0;
  header_ = detail::wire::no_header();
  report_ = StreamReport{};
  is_refused_ = false;
  is_gap_due_ = false;
  is_gap_noted_ = true;
  pieces_passed_ = 0;
  frame_bytes_ = 0;
}

PacketReader::Completed PacketReader::start_next(const PacketReader& before) {
  const bool has_ended_tag = before.has_tag_;
  const uint32_t ended_tag = before.tag_;
  const uint8_t channel =
      before.channel_ == any_channel ? detail::wire::channel_in(ended_tag) : before.channel_;
  const size_t bytes = before.kept_bytes_;
  if (this != &before) copy_bytes(frame_, before.frame_, sizeof frame_);
  start(channel);
  has_ended_tag_ = has_ended_tag;
  ended_tag_ = ended_tag;
  return bytes > 0 ? open_packet(bytes) : Completed::nothing;
}

PacketReader::Completed PacketReader::add(uint8_t byte) {
  ++report_.bytes;
  kept_bytes_ = 0;
  if (byte != 0) {
    if (frame_bytes_ < sizeof(frame_)) frame_[frame_bytes_++] = byte;
    return Completed::nothing;
  }
  const size_t bytes = frame_bytes_;
  frame_bytes_ = 0;
  return bytes == 0 ? Completed::nothing : open_frame(bytes);  // an extra delimiter is not a frame
}

void PacketReader::finish() {
  if (frame_bytes_ > 0) note_damaged();
  frame_bytes_ = 0;
  is_gap_due_ = true;
}

bool PacketReader::remove_gap() {
  const bool was_due = is_gap_due_;
  is_gap_due_ = false;
  return was_due;
}

void PacketReader::note_unreadable() {
  note_damaged();
  report_.is_unreadable = true;
}

PacketReader::Completed PacketReader::note_damaged() {
  ++report_.damaged_packets;
  return Completed::nothing;
}

PacketReader::Completed PacketReader::open_frame(size_t bytes) {
  const size_t plain_bytes = detail::cobs::unstuff(frame_, bytes);
  const bool is_packet = plain_bytes >= detail::wire::packet_head + detail::wire::packet_tail &&
                         plain_bytes <= detail::wire::max_packet;
  return is_packet ? open_packet(plain_bytes) : note_damaged();
}

PacketReader::Completed PacketReader::open_packet(size_t bytes) {
  using namespace detail::wire;
  const uint8_t* const packet = frame_ + 1;
  const size_t checked = bytes - packet_crc;
  const uint32_t crc = crc32(packet, checked);
  if (crc != ByteReader(packet + checked, packet_crc).get(4)) return note_damaged();
  payload_bytes_ = checked - packet_tag - packet_head;
  const PacketKind kind = static_cast<PacketKind>(packet[0]);
  const auto tag = static_cast<uint32_t>(ByteReader(packet + checked - packet_tag, 3).get(3));
  // A packet that begins a stream is no repetition, even if it has the previous scan's number.
  if (kind == PacketKind::header && begins_stream(payload(), payload_bytes_))
    has_ended_tag_ = has_ended_tag_ && tag != ended_tag_;
  if (!adopt(tag)) {
    ++report_.foreign_packets;
    if (has_tag_ && is_on_channel(tag)) kept_bytes_ = bytes;
    return Completed::nothing;
  }
  if (report_.has_trailer) {
    ++report_.repeated_packets;
    return Completed::nothing;
  }
  if (kind == PacketKind::header && !read_header()) return Completed::nothing;
  if (!accept_number(packet)) return Completed::nothing;
  ++report_.packets;
  const bool is_trailer = kind == PacketKind::trailer || kind == PacketKind::slices_trailer;
  if (!is_trailer) digest_ = digest_with(digest_, crc);
  if (kind == PacketKind::trailer) return read_trailer();
  if (kind == PacketKind::slices_trailer) return read_slices_trailer();
  if (kind == PacketKind::application || kind == PacketKind::slices_application)
    return payload_bytes_ < application_head ? note_damaged() : Completed::application;
  if (is_of_slices(packet[0])) return Completed::slices;
  if (kind == PacketKind::whole_regions) {
    if (payload_bytes_ < whole_regions_tail) return note_damaged();
    payload_bytes_ -= whole_regions_tail;
    return Completed::records;
  }
  return kind == PacketKind::records ? Completed::records : Completed::nothing;
}

uint32_t PacketReader::whole_regions() const {
  if (frame_[1] != static_cast<uint8_t>(detail::wire::PacketKind::whole_regions)) return 0;
  detail::wire::ByteReader tail(payload() + payload_bytes_, detail::wire::whole_regions_tail);
  return static_cast<uint32_t>(tail.get(detail::wire::whole_regions_tail));
}

ApplicationRecord PacketReader::application() const {
  detail::wire::ByteReader reader(payload(), payload_bytes_);
  ApplicationRecord record;
  record.kind = static_cast<uint8_t>(reader.get(1));
  record.slice = static_cast<uint32_t>(reader.get(4));
  record.row = static_cast<uint32_t>(reader.get(4));
  record.bytes = payload() + detail::wire::application_head;
  record.count = payload_bytes_ - detail::wire::application_head;
  return record;
}

// Whether a packet belongs to this stream; the first packet on the channel determines the scan.
bool PacketReader::adopt(uint32_t tag) {
  if (!has_tag_ && is_on_channel(tag)) {
    tag_ = tag;
    has_tag_ = true;
  }
  return has_tag_ && tag == tag_;
}

// Whether a packet is of this channel, and not of the previous scan.
bool PacketReader::is_on_channel(uint32_t tag) const {
  if (has_ended_tag_ && tag == ended_tag_) return false;
  if (channel_ == any_channel && !has_tag_) return true;
  const uint32_t channel = channel_ == any_channel ? detail::wire::channel_in(tag_) : channel_;
  const uint32_t first = detail::wire::channel_in(tag);
  return channel >= first && channel < first + detail::wire::surface_count_in(tag);
}

// Accepts a packet that is the next one or a later one, and notes a gap before it. A count of
// pieces in the upper half of its range means an earlier packet. So does a number in the upper half
// if the count is unchanged.
bool PacketReader::accept_number(const uint8_t* packet) {
  if (detail::wire::is_of_slices(packet[0])) return accept_long_number(packet);
  const uint8_t number = packet[1];
  const uint32_t piece_count = uint32_t{packet[2]} | uint32_t{packet[3]} << 8;
  const uint16_t pieces = static_cast<uint16_t>(piece_count - pieces_passed_);
  const uint8_t gap = static_cast<uint8_t>(number - packets_passed());
  const bool is_trailer = packet[0] == static_cast<uint8_t>(detail::wire::PacketKind::trailer);
  if (packets_passed() > 0 && !is_trailer && (pieces >= 0x8000 || (pieces == 0 && gap >= 128))) {
    ++report_.repeated_packets;
    return false;
  }
  note_gap(gap, is_trailer ? 0 : pieces);  // a trailer counts all pieces
  return true;
}

// Packets of slices have a longer number instead.
bool PacketReader::accept_long_number(const uint8_t* packet) {
  constexpr uint32_t numbers = uint32_t{1} << 24;
  const auto number = static_cast<uint32_t>(detail::wire::ByteReader(packet + 1, 3).get(3));
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
  is_gap_noted_ = true;
  is_gap_due_ = true;
  report_.lost_packets += packets;
  report_.lost_pieces += pieces;
  pieces_passed_ += pieces;
}

// The counts in the header have no modulus: they correct those of the packets. Returns false if
// the packet has nothing more to read.
bool PacketReader::read_header() {
  detail::wire::ByteReader reader(payload(), payload_bytes_);
  const bool has_magic = reader.get(3) == detail::wire::magic;
  is_refused_ = has_magic && reader.get(1) != detail::wire::version;
  if (is_refused_) return false;
  const HeaderPacket packet = parse_header(reader, tag_);
  if (!has_magic || payload_bytes_ < detail::wire::header_payload || !packet.header.is_valid() ||
      packet.header.levels == 6) {
    note_damaged();
    return false;
  }
  if (!report_.has_header) {
    header_ = packet.header;
    report_.holds_slices = (packet.flags & detail::wire::HeaderFlags::slices) != 0;
  }
  report_.has_header = true;
  if (packet.packets_before < packets_passed()) {
    ++report_.repeated_packets;
    return false;
  }
  const uint64_t packets_missing = packet.packets_before - packets_passed();
  const uint64_t pieces =
      packet.pieces_before > pieces_passed_ ? packet.pieces_before - pieces_passed_ : 0;
  // A gap that was noted too small, by multiples of the short number, was before the open piece.
  // The number of packets of slices is longer.
  const bool may_be_noted = is_gap_noted_ && !report_.holds_slices;
  const bool is_gap_here =
      packets_missing % 256 != 0 || pieces > 0 || (packets_missing > 0 && !may_be_noted);
  report_.lost_packets += packets_missing;
  if (is_gap_here) {
    note_gap(0, pieces);
    is_gap_due_ = true;
  }
  is_gap_noted_ = false;
  return true;
}

// Reads the beginning of both kinds of trailer.
void PacketReader::note_end(detail::wire::ByteReader& reader) {
  report_.has_trailer = true;
  report_.slices = static_cast<uint32_t>(reader.get(4));
  report_.is_abandoned = reader.get(1) != 0;
}

// The digest is meaningless if packets are missing.
void PacketReader::compare_digest(uint32_t expected) {
  report_.is_mixed = report_.lost_packets == 0 && expected != digest_;
}

PacketReader::Completed PacketReader::read_trailer() {
  if (payload_bytes_ < detail::wire::trailer_payload) return note_damaged();
  detail::wire::ByteReader reader(payload(), payload_bytes_);
  note_end(reader);
  Statistics& totals = report_.totals;
  for (const auto total : detail::wire::trailer_totals) totals.*total = reader.get(8);
  compare_digest(static_cast<uint32_t>(reader.get(4)));
  const uint64_t pieces = totals.regions + totals.fragments;
  if (pieces > pieces_passed_) note_gap(0, pieces - pieces_passed_);
  return Completed::trailer;
}

PacketReader::Completed PacketReader::read_slices_trailer() {
  if (payload_bytes_ < detail::wire::slices_trailer_payload) return note_damaged();
  detail::wire::ByteReader reader(payload(), payload_bytes_);
  note_end(reader);
  report_.total_rows = reader.get(8);
  report_.totals.skipped_rows = reader.get(8);
  compare_digest(static_cast<uint32_t>(reader.get(4)));
  return Completed::trailer;
}

}  // namespace discmc::detail::stream
