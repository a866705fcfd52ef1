// The frames of rows over a UART. README.md describes the protocol.
#pragma once

#include <discmc/stream/cobs.hpp>
#include <discmc/stream/crc32.hpp>
#include <discmc/stream/wire.hpp>

namespace row_frame {

/// The kind of a frame. The number of each kind is below.
enum class Kind : uint8_t {
  start,       ///< the scan begins; number of bytes per row
  row,         ///< samples follow; the row's number, counted over all slices from 0
  end,         ///< no row follows; number of rows
  broken_off,  ///< the scan is abandoned; number of rows
};

/// The answer of a device.
enum class Answer : uint8_t {
  restarted = 'R',  ///< the device has restarted, and waits for a start
  ready = 'S',      ///< the start is accepted; there is room for two rows
  refused = '?',    ///< the device is scanning already, or rows have another size
  taken = '+',      ///< a row has left the buffer
  dropped = '-',    ///< a frame was rejected: damaged, out of order, or without room
};

constexpr size_t head_bytes = 1 + 4;
constexpr size_t crc_bytes = 4;
constexpr size_t max_samples = discmc::detail::cobs::max_plain - head_bytes - crc_bytes;
/// With the stuffing byte and a zero at either end.
constexpr size_t max_bytes = discmc::detail::cobs::max_plain + 3;

/// Writes a frame of up to max_samples bytes of samples. Limit: there is room for max_bytes.
/// Returns its length.
inline size_t write(uint8_t* frame, Kind kind, uint32_t number, const uint8_t* samples = nullptr,
                    size_t count = 0) {
  frame[0] = 0;  // ends any incomplete frame on the line
  uint8_t* plain = frame + 2;
  plain[0] = static_cast<uint8_t>(kind);
  discmc::detail::wire::put(plain + 1, number, 4);
  for (size_t i = 0; i < count; ++i) plain[head_bytes + i] = samples[i];
  const size_t checked = head_bytes + count;
  discmc::detail::wire::put(plain + checked, discmc::crc32(plain, checked), crc_bytes);
  return 1 + discmc::detail::cobs::stuff(frame + 1, checked + crc_bytes);
}

/// Removes the stuffing of frames byte by byte, and checks frames. Finds the next frame after any
/// other bytes.
class Reader {
 public:
  enum class Event : uint8_t {
    nothing,
    byte,     ///< one more byte of the frame: plain()
    whole,    ///< the frame is valid; its last crc_bytes were the checksum
    damaged,  ///< the frame is invalid
  };

  /// Accepts a byte from the line. Cost: the same for every byte.
  Event accept(uint8_t byte) {
    if (byte == 0) return end();
    if (to_code_ == 0) {  // the first of a frame
      to_code_ = byte;
      return Event::nothing;
    }
    const bool is_code = --to_code_ == 0;
    if (is_code) to_code_ = byte;
    plain_ = is_code ? 0 : byte;
    check(plain_);
    return Event::byte;
  }

  uint8_t plain() const { return plain_; }

 private:
  static constexpr uint32_t crc_begin = 0xFFFFFFFF;
  // The checksum of any bytes followed by their checksum.
  static constexpr uint32_t crc_of_whole = 0xDEBB20E3;

  Event end() {
    const Event event = to_code_ == 0                           ? Event::nothing
                        : to_code_ == 1 && crc_ == crc_of_whole ? Event::whole
                                                                : Event::damaged;
    to_code_ = 0;
    crc_ = crc_begin;
    return event;
  }

  void check(uint8_t byte) {
    constexpr discmc::detail::derive::Crc32Table<4> table =
        discmc::detail::derive::crc32_table<4>();
    crc_ ^= byte;
    crc_ = crc_ >> 4 ^ table.remainder[crc_ & 15];
    crc_ = crc_ >> 4 ^ table.remainder[crc_ & 15];
  }

  uint32_t crc_ = crc_begin;
  uint8_t to_code_ = 0;  // bytes up to the next code, where the final zero may be
  uint8_t plain_ = 0;
};

}  // namespace row_frame
