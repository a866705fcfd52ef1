// The reports between a scanner and this computer. README.md describes the protocol.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <discmc/stream/wire.hpp>
#include <optional>

namespace discmc::device {

/// A report without its report id.
struct Report {
  static constexpr std::size_t bytes = 64;
  static constexpr std::size_t head_bytes = 8;
  static constexpr std::size_t payload_bytes = bytes - head_bytes;
  static constexpr std::uint8_t version = 1;

  enum class Kind : std::uint8_t {
    row = 1,         ///< from the scanner: a part of a row
    end = 2,         ///< from the scanner: no row follows; number: their count
    start = 3,       ///< to the scanner: begin to scan
    stop = 4,        ///< to the scanner: stop
    stream = 5,      ///< to the scanner: a part of the surface stream
    stream_end = 6,  ///< to the scanner: the stream is complete; number: its parts
  };

  Kind kind = Kind::row;
  std::uint8_t length = 0;   ///< of the payload
  std::uint16_t chunk = 0;   ///< of the row, from 0
  std::uint32_t number = 0;  ///< of the row, over all slices, or of the part; from 0
  const std::uint8_t* payload = nullptr;

  /// Size: `bytes`; bytes after the payload are 0.
  void write(std::uint8_t* report) const {
    std::fill_n(report, bytes, std::uint8_t{0});
    const auto first = static_cast<std::uint32_t>(version << 4 | static_cast<int>(kind));
    std::uint8_t* place = detail::wire::put(report, first, 1);
    place = detail::wire::put(place, length, 1);
    place = detail::wire::put(place, chunk, 2);
    detail::wire::put(place, number, 4);
    std::copy_n(payload, length, report + head_bytes);
  }

  /// Returns nothing if it is not one of these reports. Owner: the payload stays in the given
  /// bytes.
  static std::optional<Report> read(const std::uint8_t* report, std::size_t count) {
    if (count != bytes) return std::nullopt;
    detail::wire::ByteReader head(report, head_bytes);
    const auto first = static_cast<std::uint8_t>(head.get(1));
    Report read;
    read.kind = static_cast<Kind>(first & 15);
    read.length = static_cast<std::uint8_t>(head.get(1));
    read.chunk = static_cast<std::uint16_t>(head.get(2));
    read.number = static_cast<std::uint32_t>(head.get(4));
    read.payload = report + head_bytes;
    const bool is_known = first >> 4 == version && read.kind >= Kind::row &&
                          read.kind <= Kind::stream_end && read.length <= payload_bytes;
    return is_known ? std::optional<Report>(read) : std::nullopt;
  }
};

}  // namespace discmc::device
