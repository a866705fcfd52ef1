// Packets of version 1 out of the bytes of a stream.
#ifndef DISCMC_COMMAND_STREAMS_VERSION1_PACKETS_HPP
#define DISCMC_COMMAND_STREAMS_VERSION1_PACKETS_HPP

#include <cstddef>
#include <cstdint>

#include <discmc/stream/cobs.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc::host::version1 {

/// What a packet holds. Others are counted and skipped.
enum class PacketKind : std::uint8_t { header = 1, records = 2, trailer = 3 };

/// A packet, right by its checksum. Owner: the unframer, until its next byte.
struct Packet {
  PacketKind kind;
  std::uint8_t number;    ///< modulo 256
  std::uint16_t regions;  ///< complete before it, modulo 65,536
  const std::uint8_t* payload;
  std::size_t payload_bytes;
};

class Unframer {
 public:
  /// What a byte has completed: a damaged frame is none, or fails its checksum.
  enum class Found : std::uint8_t { nothing, packet, damage };
  Found take(std::uint8_t byte);
  /// Whether a frame has begun and not ended.
  bool is_within_frame() const { return bytes_ > 0; }
  /// Limit: the last byte has completed it.
  const Packet& packet() const { return packet_; }

 private:
  static constexpr std::size_t head_bytes = 1 + 1 + 2;
  static constexpr std::size_t check_bytes = 4;

  Found open(std::size_t bytes);

  Packet packet_{};
  std::size_t bytes_ = 0;  // of the frame so far; what is more than a frame is dropped
  std::uint8_t frame_[cobs::max_plain + 2] = {};
};

/// The fields of a header. Limit: a header's payload.
constexpr std::size_t header_bytes = 3 + 1 + 2 + 2 + 4 + 3 * 4 + 4 + 1 + 4 + 8;

/// Finds the first header that is of version 1.
class HeaderSearch {
 public:
  /// Whether the byte ends it.
  bool take(std::uint8_t byte);

 private:
  Unframer unframer_;
};

/// What a header says of its scan and of the stream before it.
struct ReadHeader {
  bool is_header = false;  ///< by its magic number
  bool is_known = false;   ///< by its version: the rest holds only then
  bool is_valid = false;   ///< as long as a header is, and of a scan that can be
  StreamHeader header;
  std::uint64_t packets = 0;
  std::uint64_t regions = 0;
};

ReadHeader read_header(const Packet& packet);

}  // namespace discmc::host::version1

#endif
