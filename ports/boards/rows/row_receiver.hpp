// Receives rows from the bytes of a line, in a receive interrupt. README.md describes the protocol.
#pragma once

#include "row_frame.hpp"

/// Writes samples to their row as they arrive, without a buffer. Reports only rows that are
/// complete, in order, and had room.
class RowReceiver {
 public:
  enum class Event : uint8_t {
    nothing,
    start,       ///< a scan begins
    refused,     ///< a start during a scan, or for rows of another size
    row,         ///< row number() has arrived; its number exceeds that of the previous row
    end,         ///< no row follows; there were number() rows
    broken_off,  ///< the scan was abandoned after number() rows
    dropped,     ///< a frame was rejected
  };

  /// row_bytes: Limit: row_frame::max_samples.
  explicit constexpr RowReceiver(size_t row_bytes) : row_bytes_(row_bytes) {}

  /// Accepts a byte from the line. row: memory of row_bytes for the samples of a row; null if there
  /// is none. The row may become null or not null at any byte. While it is not null, it stays the
  /// same until a row is complete.
  Event accept(uint8_t byte, void* row) {
    switch (reader_.accept(byte)) {
      case row_frame::Reader::Event::nothing:
        break;
      case row_frame::Reader::Event::byte:
        store(reader_.plain(), static_cast<uint8_t*>(row));
        break;
      case row_frame::Reader::Event::whole:
        return end_frame(has_its_length());
      case row_frame::Reader::Event::damaged:
        return end_frame(false);
    }
    return Event::nothing;
  }

  uint32_t number() const { return number_; }

 private:
  using Kind = row_frame::Kind;

  void store(uint8_t byte, uint8_t* row) {
    const size_t place = count_++;
    if (place == 0) {
      kind_ = static_cast<Kind>(byte);
      number_ = 0;
      had_room_ = true;
    } else if (place < row_frame::head_bytes) {
      number_ |= uint32_t{byte} << 8 * (place - 1);
    } else if (kind_ == Kind::row && place - row_frame::head_bytes < row_bytes_) {
      if (row == nullptr)
        had_room_ = false;
      else
        row[place - row_frame::head_bytes] = byte;
    }
  }

  bool has_its_length() const {
    const size_t samples = kind_ == Kind::row ? row_bytes_ : 0;
    return count_ == row_frame::head_bytes + samples + row_frame::crc_bytes;
  }

  // Before the start nothing counts as dropped, because it belongs to a scan before a reset.
  Event end_frame(bool is_good) {
    count_ = 0;
    if (is_good && kind_ == Kind::start) return start();
    if (!is_scanning_) return Event::nothing;
    return is_good && number_ >= next_ && number_ < UINT32_MAX ? go_on() : Event::dropped;
  }

  // A repeated start is answered again, because the answer may have been lost.
  Event start() {
    if (number_ != row_bytes_ || (is_scanning_ && next_ > 0)) return Event::refused;
    is_scanning_ = true;
    next_ = 0;
    return Event::start;
  }

  Event go_on() {
    if (kind_ == Kind::row && had_room_) {
      next_ = number_ + 1;
      return Event::row;
    }
    if (kind_ != Kind::end && kind_ != Kind::broken_off) return Event::dropped;
    is_scanning_ = false;
    return kind_ == Kind::end ? Event::end : Event::broken_off;
  }

  row_frame::Reader reader_;
  size_t row_bytes_;
  size_t count_ = 0;  // bytes of the frame so far, without the stuffing
  uint32_t number_ = 0;
  uint32_t next_ = 0;  // the lowest valid number of the next row
  Kind kind_ = Kind::start;
  bool had_room_ = true;
  bool is_scanning_ = false;
};
