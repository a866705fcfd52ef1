#include <discmc/stream/crc32.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc::detail::stream {

void PacketWriter::attach(const ByteOutput& output) {
  if (frame_bytes_ > 0 && drained_ > 0) is_cut_ = true;
  output_ = output;
  is_under_way_ = false;
  frame_bytes_ = 0;
}

void PacketWriter::begin_stream(uint8_t flags) {
  const bool has_open_border = header_.border == Border::open;
  flags_ =
      static_cast<uint8_t>(flags | (has_open_border ? detail::wire::HeaderFlags::open_border : 0));
  is_under_way_ = true;
  bytes_ = 0;
  pieces_ = 0;
  packets_ = 0;
  digest_ = 0;
  pieces_before_ = 0;
  seal_header();
  if (is_cut_) put_delimiter();
}

void PacketWriter::seal(detail::wire::PacketKind kind, uint8_t* end) {
  uint8_t* const packet = frame_ + 1;
  const auto kind_code = static_cast<uint8_t>(kind);
  const uint32_t counts = detail::wire::is_of_slices(kind_code)
                              ? packets_ << 8
                              : (packets_ & 0xFF) << 8 | pieces_before_ << 16;
  detail::wire::put(packet, kind_code | counts, detail::wire::packet_head);
  end = detail::wire::put(end, detail::wire::tag_of(header_), detail::wire::packet_tag);
  const uint32_t crc = crc32(packet, static_cast<size_t>(end - packet));
  end = detail::wire::put(end, crc, detail::wire::packet_crc);
  frame_bytes_ =
      static_cast<uint16_t>(detail::cobs::stuff(frame_, static_cast<size_t>(end - packet)));
  digest_ = detail::wire::digest_with(digest_, crc);
  drained_ = 0;
  ++packets_;
  ++packets_since_header_;
  pieces_before_ = static_cast<uint32_t>(pieces_);
}

void PacketWriter::seal_header() {
  uint8_t* end =
      detail::wire::put(payload(), detail::wire::magic | uint32_t{detail::wire::version} << 24, 4);
  end = detail::wire::put(end, header_.width, 2);
  end = detail::wire::put(end, header_.height, 2);
  end = detail::wire::put(end, header_.depth, 4);
  for (const int32_t spacing : header_.spacing_nm)
    end = detail::wire::put(end, static_cast<uint32_t>(spacing), 4);
  end = detail::wire::put(end, static_cast<uint32_t>(header_.thresholds[0]), 4);
  end = detail::wire::put(end, flags_, 1);
  end = detail::wire::put(end, packets_, 4);
  end = detail::wire::put_long(end, pieces_);
  for (uint32_t surface = 1; surface < header_.surface_count; ++surface)
    end = detail::wire::put(end, static_cast<uint32_t>(header_.thresholds[surface]), 4);
  seal(detail::wire::PacketKind::header, end);
  packets_since_header_ = 0;
}

// The delimiter precedes the sealed header, so that a truncated frame does not damage it.
DISCMC_ALWAYS_INLINE void PacketWriter::put_delimiter() {
  for (uint16_t i = frame_bytes_++; i > 0; --i) frame_[i] = frame_[i - 1];
  frame_[0] = 0;
}

void PacketWriter::seal_trailer(const Event& finish) {
  uint8_t* end = detail::wire::put(payload(), finish.slice, 4);
  end = detail::wire::put(end, finish.is_abandoned ? 1 : 0, 1);
  for (const auto total : detail::wire::trailer_totals)
    end = detail::wire::put_long(end, finish.statistics->*total);
  is_under_way_ = false;
  seal(detail::wire::PacketKind::trailer, detail::wire::put(end, digest_, 4));
}

void PacketWriter::seal_slices_trailer(uint32_t slices, bool is_abandoned, uint64_t rows,
                                       uint64_t skipped_rows) {
  uint8_t* end = detail::wire::put(payload(), slices, 4);
  end = detail::wire::put(end, is_abandoned ? 1 : 0, 1);
  end = detail::wire::put_long(end, rows);
  end = detail::wire::put_long(end, skipped_rows);
  is_under_way_ = false;
  seal(detail::wire::PacketKind::slices_trailer, detail::wire::put(end, digest_, 4));
}

void PacketWriter::seal_application(detail::wire::PacketKind kind,
                                    const ApplicationRecord& record) {
  uint8_t* end = detail::wire::put(payload(), record.kind, 1);
  end = detail::wire::put(end, record.slice, 4);
  end = detail::wire::put(end, record.row, 4);
  for (size_t i = 0; i < record.count; ++i) *end++ = record.bytes[i];
  seal(kind, end);
}

void PacketWriter::seal_appended(const RecordsPacket& packet) {
  uint8_t* end = payload();
  for (size_t i = 0; i < packet.bytes; ++i) *end++ = packet.payload[i];
  pieces_ += packet.pieces;
  if (packet.is_whole)
    end = detail::wire::put(end, packet.pieces, detail::wire::whole_regions_tail);
  seal(
      packet.is_whole ? detail::wire::PacketKind::whole_regions : detail::wire::PacketKind::records,
      end);
}

bool PacketWriter::drain() {
  while (frame_bytes_ > 0) {
    const size_t left = static_cast<size_t>(frame_bytes_ - drained_);
    const size_t written = output_.write(output_.context, frame_ + drained_, left);
    bytes_ += written;
    if (written == 0) return false;
    is_cut_ = false;
    drained_ = static_cast<uint16_t>(drained_ + written);
    if (written < left) continue;
    frame_bytes_ = 0;
    if (packets_since_header_ >= detail::wire::header_interval && is_under_way_) seal_header();
  }
  return true;
}

void PacketWriter::set_output(const ByteOutput& output) {
  output_ = output;
  if (output_.write != nullptr) return;
  output_.write = [](void*, const uint8_t*, size_t count) { return count; };
  output_.unsent = [](void*) { return size_t{0}; };
}

void PacketWriter::repeat_header(bool is_packet_empty) {
  if (!is_under_way_) return;
  packets_since_header_ = detail::wire::header_interval;
  if (is_open() && is_packet_empty) seal_header();
}

Status PacketWriter::ready_for_checkpoint() const {
  if (output_.unsent == nullptr) return Status::bad_sink;
  return output_.unsent(output_.context) > 0 ? Status::suspended : Status::ok;
}

void PacketWriter::resume(const ByteOutput& output) {
  output_ = output;
  if (frame_bytes_ > 0) bytes_ -= drained_;
  drained_ = 0;
}

}  // namespace discmc::detail::stream
