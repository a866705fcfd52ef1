#include "stream_census.hpp"

#include <discmc/stream/packet_reader.hpp>

namespace discmc::host {

void StreamCensus::take(const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (frame_.size() < wire::max_frame) frame_.push_back(bytes[i]);
    if (bytes[i] != 0) continue;
    frame_.back() = 0;
    end_frame();
    frame_.clear();
  }
}

void StreamCensus::end_frame() {
  // Stuffing leaves the kind of a packet as it is.
  constexpr auto header_kind = static_cast<std::uint8_t>(wire::PacketKind::header);
  if (frame_.size() < 2 || frame_[1] != header_kind) return;
  PacketReader reader;
  reader.start(any_channel);
  for (const std::uint8_t byte : frame_) static_cast<void>(reader.take(byte));
  if (!reader.report().has_header) return;
  const StreamHeader& header = reader.header();
  const bool is_new = known_.insert(wire::tag_of(header)).second;
  if (is_new) headers_.push_back(header);
}

}  // namespace discmc::host
