#include <discmc/receiver.hpp>

namespace discmc {

Status Receiver::start(Memory memory, const Sink& sink, uint8_t channel) {
  const Status status = decoder_.start(memory, sink, channel);
  if (status == Status::ok) is_over_ = false;
  return status;
}

Decoded Receiver::push(const uint8_t* bytes, size_t count) {
  if (is_over_) decoder_.start_next();
  is_over_ = false;
  for (size_t consumed = 0;;) {
    if (is_at_end()) {
      const Status status = decoder_.finish();
      is_over_ = status == Status::ok;
      return {is_over_ ? Status::finished : status, consumed};
    }
    // Processes one frame at a time, because the next may belong to another scan.
    size_t end = consumed;
    while (end < count && bytes[end++] != 0) continue;
    const Decoded decoded = decoder_.push(bytes + consumed, end - consumed);
    consumed += decoded.bytes;
    if (decoded.status != Status::ok || (consumed == count && !is_at_end()))
      return {decoded.status, consumed};
  }
}

Status Receiver::finish() {
  if (is_over_ && !decoder_.holds_next_scan()) return Status::ok;
  if (is_over_) decoder_.start_next();
  is_over_ = false;
  return decoder_.finish();
}

}  // namespace discmc
