// CRC-32 (IEEE 802.3, reflected, as in zlib and PNG): bit by bit, or with a table on hosts.
#ifndef DISCMC_STREAM_CRC32_HPP
#define DISCMC_STREAM_CRC32_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc {

namespace detail::derive {

/// The register after `bits` zero bits.
constexpr uint32_t crc32_shifted(uint32_t crc, int bits) {
  for (; bits > 0; --bits) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
  return crc;
}

/// The remainders of all values of `bits` bits: 64 bytes for four bits, 1 KiB for eight.
template <int bits>
struct Crc32Table {
  uint32_t remainder[1 << bits];
};

template <int bits>
constexpr Crc32Table<bits> crc32_table() {
  Crc32Table<bits> table{};
  for (uint32_t i = 0; i < 1 << bits; ++i) table.remainder[i] = crc32_shifted(i, bits);
  return table;
}

inline constexpr Crc32Table<8> crc32_of_bytes = crc32_table<8>();

}  // namespace detail::derive

/// The checksum of some bytes; `before` is the checksum of the bytes in front of them. Cost: a step
/// per byte on a host, eight on firmware, where packets are short and flash is scarce.
constexpr uint32_t crc32(const uint8_t* bytes, size_t count, uint32_t before = 0) {
  uint32_t crc = ~before;
  for (size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    if constexpr (is_host)
      crc = crc >> 8 ^ detail::derive::crc32_of_bytes.remainder[crc & 0xFF];
    else
      crc = detail::derive::crc32_shifted(crc, 8);
  }
  return ~crc;
}

}  // namespace discmc

#endif
