// The range coder alone: any bits with any probabilities, lengths, carries and ends.
#include <discmc/stream/range_coder.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using test::Bytes;
using test::Chance;

namespace {

struct Decision {
  bool bit;
  Probability one;
};
using Decisions = std::vector<Decision>;

// Bits that occur as often as their probabilities predict, or the opposite.
Decisions random_decisions(Chance& chance, size_t count, bool is_likely = true) {
  Decisions decisions(count);
  for (Decision& decision : decisions) {
    decision.one = static_cast<Probability>(1 + chance.below(255));
    decision.bit = (chance.below(256) < decision.one) == is_likely;
  }
  return decisions;
}

void encode(RangeEncoder& encoder, const Decisions& decisions) {
  for (const Decision& decision : decisions) encoder.encode(decision.bit, decision.one);
}

Bytes encoded(const Decisions& decisions) {
  Bytes bytes(decisions.size() + 8);
  RangeEncoder encoder(bytes.data(), bytes.size());
  encode(encoder, decisions);
  const size_t announced = encoder.size();
  REQUIRE(encoder.fits());
  bytes.resize(encoder.finish());
  CHECK(bytes.size() == announced);
  return bytes;
}

size_t wrong_bits(const Bytes& bytes, const Decisions& decisions) {
  RangeDecoder decoder(bytes.data(), bytes.size());
  size_t wrong = 0;
  for (const Decision& decision : decisions) wrong += decoder.decode(decision.one) != decision.bit;
  CHECK_FALSE(decoder.is_exhausted());
  return wrong;
}

void check_round_trip(const Decisions& decisions) {
  CHECK(wrong_bits(encoded(decisions), decisions) == 0);
}

// Bits chosen to keep the code as close below `target` as possible. Later bits decide whether a
// carry propagates through all of it.
Decisions towards(const Bytes& target, size_t count, Probability one) {
  RangeDecoder decoder(target.data(), target.size());
  Decisions decisions(count);
  for (Decision& decision : decisions) decision = {decoder.decode(one), one};
  return decisions;
}

}  // namespace

TEST_CASE(
    "random bits with random probabilities are decoded unchanged from code of the predicted size") {
  Chance chance(1);
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    check_round_trip(random_decisions(chance, chance.below(600), round % 3 != 0));
  }
}

TEST_CASE("long runs of equal bits are decoded unchanged for every probability") {
  for (int one = 1; one <= 255; ++one)
    for (const bool bit : {false, true}) {
      CAPTURE(one);
      check_round_trip(Decisions(700, {bit, static_cast<Probability>(one)}));
    }
}

TEST_CASE("the code is at most slightly longer than the information in the bits") {
  Chance chance(2);
  const Decisions decisions = random_decisions(chance, 20000);
  double bits = 0;
  for (const Decision& decision : decisions) {
    const double one = decision.one / 256.0;
    bits -= std::log2(decision.bit ? one : 1 - one);
  }
  CHECK(static_cast<double>(encoded(decisions).size()) < bits / 8 * 1.0005 + 2);
}

TEST_CASE("an empty sequence of bits is encoded in zero bytes") {
  CHECK(encoded({}).empty());
  CHECK(encoded({{true, 255}}).empty());
}

TEST_CASE("a carry propagates through any number of bytes 255, or stops before them") {
  int longest = 0;
  for (size_t run = 0; run < 40; ++run)
    for (size_t lead = 0; lead < 3; ++lead)
      for (const Probability one :
           {Probability{1}, Probability{77}, Probability{128}, Probability{255}}) {
        CAPTURE(run);
        Bytes target(lead, 0x5A);
        target.resize(lead + run, 0xFF);
        // Every length of the approach, followed by the lowest and the highest code.
        for (size_t count = 0; count < 8 * (lead + run) + 4; count += 3) {
          Decisions decisions = towards(target, count, one);
          for (const bool end : {false, true}) {
            Decisions ended = decisions;
            for (int i = 0; i < 20; ++i) ended.push_back({end, 128});
            const Bytes bytes = encoded(ended);
            REQUIRE(wrong_bits(bytes, ended) == 0);
            int now = 0;
            for (const uint8_t byte : bytes) {
              now = byte == 0xFF ? now + 1 : 0;
              longest = now > longest ? now : longest;
            }
          }
        }
      }
  CHECK(longest > 30);
}

TEST_CASE("a carry that turns a byte into 255 does not propagate into later bytes") {
  // Found by a search, because random bits hardly ever reach this case.
  Decisions decisions = {{false, 125}, {true, 44},   {true, 89},  {true, 42},
                         {true, 199},  {false, 124}, {false, 255}};
  check_round_trip(decisions);
  decisions.insert(decisions.end(), 40, {false, 128});
  check_round_trip(decisions);
}

TEST_CASE("bits are decoded unchanged if the range of the coder is minimal") {
  constexpr uint32_t least = 1U << 24;
  Chance chance(7);
  Decisions decisions;
  for (uint32_t range = UINT32_MAX; range != least;) {
    Decision next = random_decisions(chance, 1).front();
    for (uint32_t one = 1; one < 256; ++one) {
      const uint32_t bound = (range >> 8) * one;
      if (bound != least && range - bound != least) continue;
      next = {bound == least, static_cast<Probability>(one)};
    }
    const uint32_t bound = (range >> 8) * next.one;
    range = next.bit ? bound : range - bound;
    if (range < least) range <<= 8;
    decisions.push_back(next);
  }
  for (const Decision& decision : random_decisions(chance, 100)) decisions.push_back(decision);
  check_round_trip(decisions);
}

TEST_CASE("symbols are decoded unchanged if their share leaves the minimal range of the coder") {
  // Found by a search: the fourth symbol leaves a range of exactly 2^24.
  const uint8_t share[] = {13, 109, 185, 64, 77, 200};
  const uint32_t symbol[] = {0, 0, 0, 0, 1, 1};
  Bytes bytes(100);
  RangeEncoder encoder(bytes.data(), bytes.size());
  for (size_t i = 0; i < 6; ++i)
    encoder.encode_symbol(symbol[i] * share[i], symbol[i] == 0 ? share[i] : 256U - share[i]);
  bytes.resize(encoder.finish());
  RangeDecoder decoder(bytes.data(), bytes.size());
  for (size_t i = 0; i < 6; ++i) {
    const uint8_t row[] = {0, share[i], 0};
    CHECK(decoder.decode_symbol(row) == symbol[i]);
  }
  CHECK_FALSE(decoder.is_exhausted());
}

TEST_CASE("restoring a snapshot undoes all later bits") {
  Chance chance(3);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    Decisions kept;
    Bytes bytes(4000);
    RangeEncoder encoder(bytes.data(), bytes.size());
    for (int step = 0; step < 12; ++step) {
      const RangeEncoder before = encoder;
      const Decisions more = random_decisions(chance, chance.below(60));
      encode(encoder, more);
      if (chance.below(2) == 0)
        encoder = before;
      else
        kept.insert(kept.end(), more.begin(), more.end());
    }
    bytes.resize(encoder.finish());
    CHECK(bytes == encoded(kept));
  }
}

TEST_CASE("an exhausted buffer is reported, and no byte is written beyond it") {
  Chance chance(4);
  const Decisions decisions = random_decisions(chance, 400);
  const size_t needed = encoded(decisions).size();
  for (size_t capacity = 0; capacity <= needed + 2; ++capacity) {
    CAPTURE(capacity);
    Bytes bytes(capacity + 16, 0xA5);
    RangeEncoder encoder(bytes.data(), capacity);
    encode(encoder, decisions);
    CHECK(encoder.fits() == (capacity >= needed));
    CHECK(encoder.size() == needed);
    CHECK(encoder.finish() == needed);
    for (size_t i = capacity; i < bytes.size(); ++i) REQUIRE(bytes[i] == 0xA5);
  }
}

TEST_CASE("size() shrinks by at most one byte from one bit to the next") {
  Chance chance(5);
  Bytes bytes(1000);
  RangeEncoder encoder(bytes.data(), bytes.size());
  size_t before = encoder.size();
  for (const Decision& decision : random_decisions(chance, 3000)) {
    encoder.encode(decision.bit, decision.one);
    CHECK(encoder.size() + 1 >= before);
    CHECK(encoder.size() <= before + 2);
    before = encoder.size();
  }
}

TEST_CASE("a decoder that reads past the end is exhausted after a bounded number of bits") {
  Chance chance(6);
  for (size_t count = 0; count < 40; ++count) {
    Bytes bytes(count);
    for (uint8_t& byte : bytes) byte = chance.byte();
    RangeDecoder decoder(bytes.data(), bytes.size());
    // The cheapest bit costs log2(256 / 255) bits, so 1,418 of them cost a byte.
    size_t bits = 0;
    while (!decoder.is_exhausted() && bits < 1420 * (count + 8)) {
      (void)decoder.decode(bits % 2 == 0 ? 255 : 1);
      ++bits;
    }
    CHECK(decoder.is_exhausted());
  }
}

TEST_CASE("a decoder is exhausted at the fifth byte beyond the end, but not at the fourth") {
  for (size_t count = 0; count < 5; ++count) {
    const Bytes bytes(count, 0x55);
    RangeDecoder decoder(bytes.data(), bytes.size());
    // Nine bits of probability one half cost slightly more than a byte.
    for (size_t byte = 0; byte < count; ++byte)
      for (int bit = 0; bit < 8; ++bit) (void)decoder.decode(128);
    CHECK_FALSE(decoder.is_exhausted());
    for (int bit = 0; bit < 9; ++bit) (void)decoder.decode(128);
    CHECK(decoder.is_exhausted());
  }
}

TEST_CASE("a decoder returns the number of unread bytes, which is zero beyond the end") {
  const Bytes bytes(9, 0xA5);
  RangeDecoder decoder(bytes.data(), bytes.size());
  size_t left = 5;
  CHECK(decoder.left() == left);
  for (int bit = 0; bit < 200; ++bit) {
    (void)decoder.decode(Probability{128});
    CHECK(decoder.left() <= left);
    CHECK(decoder.left() + 1 >= left);
    left = decoder.left();
    CHECK(decoder.rest() == bytes.data() + bytes.size() - left);
  }
  CHECK(left == 0);
}
