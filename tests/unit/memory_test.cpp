// A part of the caller's memory.
#include <discmc/memory.hpp>

#include "test.hpp"

using namespace discmc;

TEST_CASE("memory_of() covers all bytes of an array of any element type") {
  uint8_t bytes[7];
  uint32_t words[3];
  std::array<std::byte, 5> wrapped{};
  std::vector<uint16_t> halves(9);
  CHECK(memory_of(bytes).data == bytes);
  CHECK(memory_of(bytes).bytes == 7);
  CHECK(memory_of(words).bytes == 12);
  CHECK(memory_of(wrapped).data == wrapped.data());
  CHECK(memory_of(wrapped).bytes == 5);
  CHECK(memory_of(halves).data == halves.data());
  CHECK(memory_of(halves).bytes == 18);
}
