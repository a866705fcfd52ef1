// Reads the streams of tests/support/golden, and shows how another stream differs.
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

inline std::string hex(const Bytes& bytes) {
  std::ostringstream text;
  for (const uint8_t byte : bytes) text << std::hex << (byte < 16 ? " 0" : " ") << int{byte};
  return text.str();
}

}  // namespace discmc::test
