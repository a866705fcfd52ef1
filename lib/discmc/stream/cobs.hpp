// Consistent overhead byte stuffing, in place, for frames of up to 254 bytes.
// A zero byte ends a frame and occurs nowhere else in it, so a reader finds the next frame after
// any loss. S. Cheshire, M. Baker, "Consistent Overhead Byte Stuffing", IEEE/ACM Transactions on
// Networking, 1999.
#ifndef DISCMC_STREAM_COBS_HPP
#define DISCMC_STREAM_COBS_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc::detail::cobs {

constexpr size_t max_plain = 254;

/// Stuffs the `count` bytes at frame[1]. Afterwards frame[0] to frame[count + 1] are the frame on
/// the wire, with its final zero. Limit: count <= max_plain; frame has count + 2 bytes. Returns the
/// length of the frame: count + 2.
constexpr size_t stuff(uint8_t* frame, size_t count) {
  size_t next = count + 1;
  frame[next] = 0;
  frame[0] = 0;
  for (size_t i = next; i-- > 0;) {
    if (frame[i] != 0) continue;
    frame[i] = static_cast<uint8_t>(next - i);
    next = i;
  }
  return count + 2;
}

/// Undoes stuff() for the `count` bytes before the final zero; the plain bytes are then at
/// frame[1]. Returns their number, or 0 if the frame is damaged.
constexpr size_t unstuff(uint8_t* frame, size_t count) {
  if (count < 2) return 0;
  size_t code = 0;
  while (code < count) {
    const size_t next = code + frame[code];
    if (frame[code] == 0 || next > count) return 0;
    frame[code] = 0;
    code = next;
  }
  return count - 1;
}

}  // namespace discmc::detail::cobs

#endif
