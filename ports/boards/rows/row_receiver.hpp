// Rows from the bytes of a line: what a receive interrupt calls. README.md is the protocol.
#pragma once

#include "row_frame.hpp"

/// Writes samples where they belong as they come, holds none, and lets only those rows through that
/// are whole, in order, and had room.
class RowReceiver {
 public:
  enum class Event : uint8_t {
    nothing,
    start,       ///< a scan begins
    refused,     ///< a start during a scan, or for rows of another size
    row,         ///< the row has come that is number(), which is higher than the one before
    end,         ///< no row follows: there were number()
    broken_off,  ///< no row follows, against the plan: there were number()
    dropped,     ///< a frame was of no use
  };

  /// row_bytes: Limit: row_frame::max_samples.
  explicit constexpr RowReceiver(size_t row_bytes) : row_bytes_(row_bytes) {}

  /// Takes a byte from the line. row: where the samples of a row go, room for row_bytes; null when
  /// there is none. The row may become null or not null at any byte. While it is not null, it stays
  /// the same one until a row is in it.
  Event take(uint8_t byte, void* row) {
    switch (reader_.take(byte)) {
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

  // Before the start nothing is dropped: it belongs to a scan from before a reset.
  Event end_frame(bool is_good) {
    count_ = 0;
    if (is_good && kind_ == Kind::start) return start();
    if (!is_scanning_) return Event::nothing;
    return is_good && number_ >= next_ && number_ < UINT32_MAX ? go_on() : Event::dropped;
  }

  // A start that comes again is answered again, for the answer may have been lost.
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
  uint32_t next_ = 0;  // the least number that the next row may have
  Kind kind_ = Kind::start;
  bool had_room_ = true;
  bool is_scanning_ = false;
};
