#include "scan_filter.hpp"

namespace discmc::meshing {

std::vector<std::uint8_t> ScanFilter::select(const std::uint8_t* bytes, std::size_t count) {
  std::vector<std::uint8_t> passed;
  frames_.push(bytes, count, [&](const std::vector<std::uint8_t>& frame) {
    if (!is_other_scan(frame)) passed.insert(passed.end(), frame.begin(), frame.end());
  });
  return passed;
}

// The tag precedes the checksum. Damaged frames may contain any tag, so the decoder gets them.
bool ScanFilter::is_other_scan(std::vector<std::uint8_t> frame) const {
  if (frame.size() > detail::wire::max_frame) return false;
  const std::size_t plain = detail::cobs::unstuff(frame.data(), frame.size() - 1);
  if (plain < detail::wire::packet_head + detail::wire::packet_tail) return false;
  const std::uint8_t* const tag = frame.data() + 1 + plain - detail::wire::packet_tail;
  return detail::wire::ByteReader(tag, detail::wire::packet_tag).get(2) != scan_;
}

}  // namespace discmc::meshing
