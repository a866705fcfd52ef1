// The checksum of a packet, compared with its published check value and its definition.
#include <doctest/doctest.h>
#include <discmc/stream/crc32.hpp>

#include <vector>

using discmc::crc32;

namespace {

std::vector<uint8_t> bytes_of(const char* text) {
  std::vector<uint8_t> bytes;
  for (; *text != '\0'; ++text) bytes.push_back(static_cast<uint8_t>(*text));
  return bytes;
}

uint32_t check_of(const std::vector<uint8_t>& bytes) {
  return crc32(bytes.data(), bytes.size());
}

// Bit by bit, as in the standard: a division by the polynomial, lowest bit first.
uint32_t by_definition(const std::vector<uint8_t>& bytes) {
  uint32_t remainder = 0xFFFFFFFF;
  for (const uint8_t byte : bytes)
    for (int bit = 0; bit < 8; ++bit) {
      const bool is_odd = ((remainder ^ static_cast<uint32_t>(byte >> bit)) & 1) != 0;
      remainder = remainder >> 1 ^ (is_odd ? 0xEDB88320U : 0U);
    }
  return remainder ^ 0xFFFFFFFF;
}

std::vector<uint8_t> pattern(size_t count) {
  std::vector<uint8_t> bytes(count);
  for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<uint8_t>(i * 149 + i / 7);
  return bytes;
}

}  // namespace

TEST_CASE("the CRC-32 has the published check values") {
  CHECK(check_of(bytes_of("123456789")) == 0xCBF43926);
  CHECK(check_of(bytes_of("")) == 0);
  CHECK(check_of(bytes_of("a")) == 0xE8B7BE43);
  CHECK(check_of(bytes_of("The quick brown fox jumps over the lazy dog")) == 0x414FA339);
}

TEST_CASE("the CRC-32 of any length equals its bitwise definition") {
  for (size_t count = 0; count <= 300; ++count) {
    CAPTURE(count);
    CHECK(check_of(pattern(count)) == by_definition(pattern(count)));
  }
}

TEST_CASE("the CRC-32 can be computed at compile time") {
  constexpr uint8_t nine[9] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  static_assert(crc32(nine, 9) == 0xCBF43926, "the check value of CRC-32");
}

TEST_CASE("the table-driven CRC-32, four bits at a time, equals the bitwise CRC-32") {
  discmc::detail::derive::Crc32Table<4> table{};
  table = discmc::detail::derive::crc32_table<4>();  // at run time, not by the compiler
  for (size_t count = 0; count < 300; ++count) {
    uint32_t crc = 0xFFFFFFFF;
    for (const uint8_t byte : pattern(count)) {
      crc = crc >> 4 ^ table.remainder[(crc ^ byte) & 15];
      crc = crc >> 4 ^ table.remainder[(crc ^ byte >> 4) & 15];
    }
    CHECK(~crc == by_definition(pattern(count)));
  }
}

TEST_CASE("the CRC-32 detects every one-bit and two-bit error of a full packet") {
  std::vector<uint8_t> packet = pattern(250);
  const uint32_t whole = check_of(packet);
  const auto flip = [&](size_t bit) {
    packet[bit / 8] = static_cast<uint8_t>(packet[bit / 8] ^ 1 << bit % 8);
  };
  int missed = 0;
  for (size_t first = 0; first < 2000; ++first) {
    flip(first);
    missed += check_of(packet) == whole;
    const size_t second = (first * 7 + 13) % 2000;
    if (second != first) {
      flip(second);
      missed += check_of(packet) == whole;
      flip(second);
    }
    flip(first);
  }
  CHECK(missed == 0);
}
