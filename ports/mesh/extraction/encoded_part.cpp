#include "encoded_part.hpp"

#include <algorithm>
#include <stdexcept>

#include <discmc/stream/cobs.hpp>
#include <discmc/stream/record_reading.hpp>
#include <discmc/stream/wire.hpp>

#include "require.hpp"

namespace discmc::meshing {
namespace {

// Whether a region that an earlier packet has begun continues in this one.
bool continues_region(const std::uint8_t* payload, std::size_t bytes) {
  detail::stream::ReadingModel model({RangeDecoder(payload, bytes)});
  if (model.record_kind(detail::stream::RecordKind::end) != detail::stream::RecordKind::part)
    return false;
  detail::stream::Record record;
  model.part(record, false);
  return record.continues;
}

}  // namespace

SinkResult EncodedPart::accept(const Event& event) {
  if (event.kind == Event::Kind::start)
    require(encoder_.start({}, {this, [](void* self, const std::uint8_t* frame, std::size_t bytes) {
                                  return static_cast<EncodedPart*>(self)->keep(frame, bytes);
                                }}));
  if (event.kind == Event::Kind::region_end) ++pieces_;
  return encoder_.accept(event);
}

void EncodedPart::accept_region(const OneRingRegion& region) {
  send_events(region, [this](const Event& event) { return accept(event) == SinkResult::accepted; });
}

// Keeps frames, which an encoder offers one at a time. The encoder of the whole volume sends the
// headers.
std::size_t EncodedPart::keep(const std::uint8_t* frame, std::size_t bytes) {
  std::uint8_t plain[detail::wire::max_frame];
  std::copy_n(frame, bytes, plain);
  const std::uint8_t* const packet = plain + 1;
  const std::size_t count = detail::cobs::unstuff(plain, bytes - 1);
  if (packet[0] != static_cast<std::uint8_t>(detail::wire::PacketKind::records)) return bytes;
  detail::wire::ByteReader head(packet + 2, 2);
  const auto pieces_before = static_cast<std::uint16_t>(head.get(2));
  const std::uint8_t* const payload = packet + detail::wire::packet_head;
  const std::uint8_t* const end = packet + count - detail::wire::packet_tail;
  payloads_.insert(payloads_.end(), payload, end);
  const bool continues = continues_region(payload, static_cast<std::size_t>(end - payload));
  if (continues) packets_.back().is_whole = false;
  const bool is_whole = !continues && payload + detail::wire::max_whole_regions >= end;
  packets_.push_back({payloads_.size(), pieces_before, is_whole});
  return bytes;
}

void EncodedPart::append_to(Encoder& encoder) {
  if (encoder_.flush() != Status::ok)
    throw std::logic_error("a part's encoder holds back a packet");
  std::size_t begin = 0;
  for (std::size_t i = 0; i < packets_.size(); ++i) {
    const Packet& packet = packets_[i];
    const bool is_last = i + 1 == packets_.size();
    const std::uint16_t pieces_after = is_last ? pieces_ : packets_[i + 1].pieces_before;
    const auto pieces = static_cast<std::uint16_t>(pieces_after - packet.pieces_before);
    require(
        encoder.append({payloads_.data() + begin, packet.end - begin, pieces, packet.is_whole}));
    begin = packet.end;
  }
}

}  // namespace discmc::meshing
