// CRC-32 (IEEE 802.3, reflected, as in zlib and PNG): bit by bit, and a table for those in a hurry.
#ifndef DISCMC_CRC32_HPP
#define DISCMC_CRC32_HPP

#include <stddef.h>
#include <stdint.h>

namespace discmc {

namespace derive {

/// The register after `bits` zero bits.
constexpr uint32_t crc32_shifted(uint32_t crc, int bits) {
  for (; bits > 0; --bits) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
  return crc;
}

/// What four bits come to at a time. 64 bytes.
struct Crc32Table {
  uint32_t remainder[16];
};

constexpr Crc32Table crc32_table() {
  Crc32Table table{};
  for (uint32_t nibble = 0; nibble < 16; ++nibble)
    table.remainder[nibble] = crc32_shifted(nibble, 4);
  return table;
}

}  // namespace derive

/// The checksum of some bytes, or of those that `before` is the checksum of and these. Cost: eight
/// steps a byte, as a packet is short and a table is not.
constexpr uint32_t crc32(const uint8_t* bytes, size_t count, uint32_t before = 0) {
  uint32_t crc = ~before;
  for (size_t i = 0; i < count; ++i) crc = derive::crc32_shifted(crc ^ bytes[i], 8);
  return ~crc;
}

}  // namespace discmc

#endif
