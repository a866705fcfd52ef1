// Packets of streams of version 1, taken apart and mended. Their layout does not change any more.
#ifndef DISCMC_TESTS_ORACLE_VERSION1_PACKETS_HPP
#define DISCMC_TESTS_ORACLE_VERSION1_PACKETS_HPP

#include <cstdint>
#include <discmc/stream/cobs.hpp>
#include <discmc/stream/crc32.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stream.hpp"

namespace discmc::test::version1 {

using Bytes = std::vector<uint8_t>;

constexpr size_t max_payload = 246;

struct Packet {
  uint8_t kind = 0;
  uint8_t number = 0;
  uint16_t regions = 0;
  Bytes payload;
};

/// Limit: a payload that fits.
inline Bytes frame_of(const Packet& packet) {
  Bytes frame{0, packet.kind, packet.number, static_cast<uint8_t>(packet.regions),
              static_cast<uint8_t>(packet.regions >> 8)};
  for (const uint8_t byte : packet.payload) frame.push_back(byte);
  return test::sealed_frame(std::move(frame));
}

/// Limit: a whole frame with its zero.
inline Packet packet_of(Bytes frame) {
  const size_t plain = cobs::unstuff(frame.data(), frame.size() - 1);
  if (plain < 8) throw std::runtime_error("no packet");
  Packet packet{frame[1], frame[2], static_cast<uint16_t>(frame[3] | frame[4] << 8), {}};
  packet.payload.assign(frame.begin() + 5, frame.begin() + static_cast<std::ptrdiff_t>(plain) - 3);
  return packet;
}

/// A header of a scan of one voxel, closed, with nothing before it.
inline Packet any_header() {
  Packet packet{1, 0, 0, {'D', 'M', 'C', 1, 1, 0, 1, 0, 1}};
  packet.payload.resize(41);
  return packet;
}

}  // namespace discmc::test::version1

#endif
