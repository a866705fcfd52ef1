#include "scan_filter.hpp"

#include <discmc/stream/wire.hpp>

namespace discmc::host {

std::vector<std::uint8_t> ScanFilter::take(const std::uint8_t* bytes, std::size_t count) {
  std::vector<std::uint8_t> passed;
  for (std::size_t i = 0; i < count; ++i) {
    // Of one that is too long for a packet no more than that is kept.
    if (frame_.size() <= wire::max_frame || bytes[i] == 0) frame_.push_back(bytes[i]);
    if (bytes[i] != 0) continue;
    if (!is_other_scan()) passed.insert(passed.end(), frame_.begin(), frame_.end());
    frame_.clear();
  }
  return passed;
}

// The tag stands before the checksum. What is damaged may say anything, and is left to the decoder.
bool ScanFilter::is_other_scan() const {
  if (frame_.size() > wire::max_frame) return false;
  std::vector<std::uint8_t> frame = frame_;
  const std::size_t plain = cobs::unstuff(frame.data(), frame.size() - 1);
  if (plain < wire::packet_head + wire::packet_tail) return false;
  const std::uint8_t* const tag = frame.data() + 1 + plain - wire::packet_tail;
  return wire::ByteReader(tag, wire::packet_tag).get(2) != scan_;
}

}  // namespace discmc::host
