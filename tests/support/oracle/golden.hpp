// Reads the streams of tests/support/golden, and compares others with them.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "stream.hpp"

namespace discmc::test {

inline Bytes golden(const char* name) {
  const std::string path = std::string(DISCMC_SOURCE_DIR) + "/tests/support/golden/" + name;
  std::ifstream file(path, std::ios::binary);
  REQUIRE_MESSAGE(file, path);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return {bytes.begin(), bytes.end()};
}

/// Likewise, and checks that the encoder made the same bytes.
inline Bytes golden_of(const char* name, const Bytes& made) {
  std::ostringstream text;
  for (const uint8_t byte : made) text << std::hex << (byte < 16 ? " 0" : " ") << int{byte};
  const Bytes bytes = golden(name);
  CHECK_MESSAGE(made == bytes, "the encoder now makes", text.str());
  return bytes;
}

}  // namespace discmc::test
