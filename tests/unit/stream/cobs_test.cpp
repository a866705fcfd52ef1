// The stuffing of frames: every length, every position of a zero, and invalid bytes.
#include <discmc/stream/cobs.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using test::Bytes;
using test::Chance;

namespace {

// A block on the heap of exactly the frame's length, so that sanitizers detect a byte beyond.
Bytes stuffed(const Bytes& plain) {
  Bytes frame(plain.size() + 2, 0xEE);
  std::copy(plain.begin(), plain.end(), frame.begin() + 1);
  const size_t length = detail::cobs::stuff(frame.data(), plain.size());
  REQUIRE(length == frame.size());
  return frame;
}

Bytes unstuffed(Bytes frame) {
  frame.pop_back();
  const size_t count = detail::cobs::unstuff(frame.data(), frame.size());
  if (count == 0) return {};
  return {frame.begin() + 1, frame.begin() + 1 + static_cast<std::ptrdiff_t>(count)};
}

void check_round_trip(const Bytes& plain) {
  const Bytes frame = stuffed(plain);
  CHECK(std::count(frame.begin(), frame.end() - 1, 0) == 0);
  CHECK(frame.back() == 0);
  CHECK(unstuffed(frame) == plain);
}

}  // namespace

TEST_CASE("the examples of the COBS paper are encoded as in the paper") {
  CHECK(stuffed({}) == Bytes{1, 0});
  CHECK(stuffed({0}) == Bytes{1, 1, 0});
  CHECK(stuffed({0, 0}) == Bytes{1, 1, 1, 0});
  CHECK(stuffed({0x11, 0x22, 0, 0x33}) == Bytes{3, 0x11, 0x22, 2, 0x33, 0});
  CHECK(stuffed({0x11, 0, 0, 0}) == Bytes{2, 0x11, 1, 1, 1, 0});
}

TEST_CASE(
    "frames of every length are decoded unchanged: without zeros, all zeros, random and sparse") {
  Chance chance(1);
  for (size_t count = 0; count <= detail::cobs::max_plain; ++count) {
    CAPTURE(count);
    Bytes counting(count), random(count), sparse(count);
    for (size_t i = 0; i < count; ++i) {
      counting[i] = static_cast<uint8_t>(i % 255 + 1);
      random[i] = chance.byte();
      sparse[i] = chance.below(60) == 0 ? 0 : 0xFF;
    }
    check_round_trip(counting);
    check_round_trip(Bytes(count, 0));
    check_round_trip(random);
    check_round_trip(sparse);
  }
}

TEST_CASE("a zero at any position of a full frame is encoded and decoded unchanged") {
  for (size_t place = 0; place < detail::cobs::max_plain; ++place) {
    CAPTURE(place);
    Bytes plain(detail::cobs::max_plain, 7);
    plain[place] = 0;
    check_round_trip(plain);
  }
}

TEST_CASE("a full frame without zeros is encoded in one more byte, and begins with 255") {
  const Bytes frame = stuffed(Bytes(detail::cobs::max_plain, 7));
  CHECK(frame.size() == 256);
  CHECK(frame[0] == 255);
}

TEST_CASE("invalid frames decode to zero bytes") {
  const auto count_of = [](Bytes bytes) {
    return detail::cobs::unstuff(bytes.data(), bytes.size());
  };
  CHECK(count_of({}) == 0);
  CHECK(count_of({1}) == 0);
  CHECK(count_of({3, 5}) == 0);        // the first distance points beyond the end
  CHECK(count_of({2, 5, 200}) == 0);   // the second distance points beyond the end
  CHECK(count_of({1, 0, 1, 1}) == 0);  // a zero within a frame
  CHECK(count_of({3, 5, 6}) == 2);
}

TEST_CASE("unstuff() of any bytes yields fewer bytes than the frame has") {
  Chance chance(2);
  int frames = 0;
  for (int round = 0; round < 60000; ++round) {
    const size_t count = chance.below(257);
    const uint32_t most = 1 + chance.below(256);
    Bytes bytes(count);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(chance.below(most));
    const size_t plain = detail::cobs::unstuff(bytes.data(), count);
    CHECK_LE(plain, count > 0 ? count - 1 : 0);
    frames += plain > 0;
  }
  CHECK(frames > 0);
}

TEST_CASE("a frame that can be decoded equals the encoding of its result") {
  Chance chance(3);
  for (int round = 0; round < 20000; ++round) {
    Bytes frame(2 + chance.below(40));
    for (uint8_t& byte : frame) byte = static_cast<uint8_t>(1 + chance.below(5));
    frame.push_back(0);
    const Bytes plain = unstuffed(frame);
    if (!plain.empty()) CHECK(stuffed(plain) == frame);
  }
}
