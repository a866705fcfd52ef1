#include <discmc/stream/crc32.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc {

void PacketWriter::open(const ByteOutput& output) {
  if (frame_bytes_ > 0 && drained_ > 0) is_cut_ = true;
  output_ = output;
  is_under_way_ = false;
  frame_bytes_ = 0;
}

void PacketWriter::start(const StreamHeader& header, uint8_t flags) {
  header_ = header;
  const bool is_open = header.border == Border::open;
  flags_ = static_cast<uint8_t>(flags | (is_open ? wire::HeaderFlags::open_border : 0));
  is_under_way_ = true;
  bytes_ = 0;
  pieces_ = 0;
  packets_ = 0;
  digest_ = 0;
  pieces_before_ = 0;
  seal_header();
  if (is_cut_) put_delimiter();
}

void PacketWriter::seal(wire::PacketKind kind, uint8_t* end) {
  uint8_t* const packet = frame_ + 1;
  const auto number = static_cast<uint8_t>(kind);
  const uint32_t passed =
      wire::is_of_slices(number) ? packets_ << 8 : (packets_ & 0xFF) << 8 | pieces_before_ << 16;
  wire::put(packet, number | passed, wire::packet_head);
  end = wire::put(end, wire::tag_of(header_), wire::packet_tag);
  const uint32_t crc = crc32(packet, static_cast<size_t>(end - packet));
  end = wire::put(end, crc, wire::packet_crc);
  frame_bytes_ = static_cast<uint16_t>(cobs::stuff(frame_, static_cast<size_t>(end - packet)));
  digest_ = wire::digest_with(digest_, crc);
  drained_ = 0;
  ++packets_;
  ++packets_since_header_;
  pieces_before_ = static_cast<uint32_t>(pieces_);
}

void PacketWriter::seal_header() {
  uint8_t* place = wire::put(payload(), wire::magic | uint32_t{wire::version} << 24, 4);
  place = wire::put(place, header_.width, 2);
  place = wire::put(place, header_.height, 2);
  place = wire::put(place, header_.depth, 4);
  for (const int32_t spacing : header_.spacing_nm)
    place = wire::put(place, static_cast<uint32_t>(spacing), 4);
  place = wire::put(place, static_cast<uint32_t>(header_.threshold), 4);
  place = wire::put(place, flags_, 1);
  place = wire::put(place, packets_, 4);
  place = wire::put_long(place, pieces_);
  for (uint32_t surface = 1; surface < header_.surfaces(); ++surface)
    place = wire::put(place, static_cast<uint32_t>(header_.threshold_of(surface)), 4);
  seal(wire::PacketKind::header, place);
  packets_since_header_ = 0;
}

// Before the sealed header, so that what is there of a frame does not take it with it.
void PacketWriter::put_delimiter() {
  for (uint16_t i = frame_bytes_++; i > 0; --i) frame_[i] = frame_[i - 1];
  frame_[0] = 0;
}

void PacketWriter::seal_trailer(const Event& finish) {
  uint8_t* place = wire::put(payload(), finish.slice, 4);
  place = wire::put(place, finish.abandoned ? 1 : 0, 1);
  for (const auto total : wire::trailer_totals)
    place = wire::put_long(place, finish.statistics->*total);
  is_under_way_ = false;
  seal(wire::PacketKind::trailer, wire::put(place, digest_, 4));
}

void PacketWriter::seal_slices_trailer(uint32_t slices, bool is_abandoned, uint64_t rows,
                                       uint64_t skipped_rows) {
  uint8_t* place = wire::put(payload(), slices, 4);
  place = wire::put(place, is_abandoned ? 1 : 0, 1);
  place = wire::put_long(place, rows);
  place = wire::put_long(place, skipped_rows);
  is_under_way_ = false;
  seal(wire::PacketKind::slices_trailer, wire::put(place, digest_, 4));
}

void PacketWriter::seal_application(wire::PacketKind kind, const ApplicationRecord& record) {
  uint8_t* place = wire::put(payload(), record.kind, 1);
  place = wire::put(place, record.slice, 4);
  place = wire::put(place, record.row, 4);
  for (size_t i = 0; i < record.count; ++i) *place++ = record.bytes[i];
  seal(kind, place);
}

void PacketWriter::seal_appended(const RecordsPacket& packet) {
  uint8_t* place = payload();
  for (size_t i = 0; i < packet.bytes; ++i) *place++ = packet.payload[i];
  pieces_ += packet.pieces;
  if (packet.is_whole) place = wire::put(place, packet.pieces, wire::whole_regions_tail);
  seal(packet.is_whole ? wire::PacketKind::whole_regions : wire::PacketKind::records, place);
}

bool PacketWriter::drain() {
  while (frame_bytes_ > 0) {
    const size_t left = static_cast<size_t>(frame_bytes_ - drained_);
    const size_t taken = output_.write(output_.context, frame_ + drained_, left);
    bytes_ += taken;
    if (taken == 0) return false;
    is_cut_ = false;
    drained_ = static_cast<uint16_t>(drained_ + taken);
    if (taken < left) continue;
    frame_bytes_ = 0;
    if (packets_since_header_ >= wire::header_interval && is_under_way_) seal_header();
  }
  return true;
}

void PacketWriter::set_output(const ByteOutput& output) {
  output_ = output;
  if (output_.write == nullptr)
    output_.write = [](void*, const uint8_t*, size_t count) { return count; };
}

void PacketWriter::repeat_header(bool packet_is_empty) {
  if (!is_under_way_) return;
  packets_since_header_ = wire::header_interval;
  if (is_open() && packet_is_empty) seal_header();
}

void PacketWriter::rewind() {
  output_ = {};
  if (frame_bytes_ > 0) bytes_ -= drained_;
  drained_ = 0;
}

}  // namespace discmc
