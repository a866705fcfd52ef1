// CRC-32 (IEEE 802.3, reflected, as in zlib and PNG), four bits at a time: 64 bytes of table.
#ifndef DISCMC_CRC32_HPP
#define DISCMC_CRC32_HPP

#include <stddef.h>
#include <stdint.h>

namespace discmc {

namespace derive {

struct Crc32Table {
  uint32_t remainder[16];
};

constexpr Crc32Table crc32_table() {
  Crc32Table table{};
  for (uint32_t nibble = 0; nibble < 16; ++nibble) {
    uint32_t crc = nibble;
    for (int bit = 0; bit < 4; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
    table.remainder[nibble] = crc;
  }
  return table;
}

}  // namespace derive

/// The checksum of some bytes. Cost: two look-ups a byte.
constexpr uint32_t crc32(const uint8_t* bytes, size_t count) {
  constexpr derive::Crc32Table table = derive::crc32_table();
  uint32_t crc = 0xFFFFFFFFU;
  for (size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    crc = crc >> 4 ^ table.remainder[crc & 15];
    crc = crc >> 4 ^ table.remainder[crc & 15];
  }
  return ~crc;
}

}  // namespace discmc

#endif
