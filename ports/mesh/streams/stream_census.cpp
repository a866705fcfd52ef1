#include "stream_census.hpp"

#include <discmc/stream/packet_reader.hpp>

namespace discmc::meshing {

void StreamCensus::add(const std::uint8_t* bytes, std::size_t count) {
  frames_.push(bytes, count, [this](const std::vector<std::uint8_t>& frame) { look_at(frame); });
}

void StreamCensus::look_at(const std::vector<std::uint8_t>& frame) {
  // Byte stuffing does not change the kind of a packet.
  constexpr auto header_kind = static_cast<std::uint8_t>(detail::wire::PacketKind::header);
  if (frame.size() < 2 || frame[1] != header_kind) return;
  detail::stream::PacketReader reader;
  reader.start(any_channel);
  for (const std::uint8_t byte : frame) static_cast<void>(reader.add(byte));
  if (reader.is_refused()) {
    detail::wire::ByteReader fields(reader.payload(), reader.payload_bytes());
    other_version_ = static_cast<std::uint8_t>(fields.get(3 + 1) >> 24);  // after the magic number
  }
  if (!reader.report().has_header) return;
  const StreamHeader& header = reader.header();
  const bool is_new = tags_.insert(detail::wire::tag_of(header)).second;
  if (is_new) headers_.push_back(header);
}

}  // namespace discmc::meshing
