// Packed samples, compared bit by bit with the tables of the standards. The tests pack each bit at
// its position, and unpack.
#include <discmc/front/packed_samples.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;

namespace {

/// The position of a bit of a sample: the byte in the group, and the bit in the byte.
struct Place {
  uint32_t byte, bit;
};

struct Layout {
  Packing packing;
  uint32_t bits;
  Place (*place)(uint32_t sample, uint32_t bit);
};

// The upper eight bits have a byte of their own; the lower bits share the last byte.
template <uint32_t low, uint32_t shared>
Place mipi(uint32_t sample, uint32_t bit) {
  return bit >= low ? Place{sample, bit - low} : Place{shared, low * sample + bit};
}
template <uint32_t bits>
Place lowest_first(uint32_t sample, uint32_t bit) {
  const uint32_t at = bits * sample + bit;
  return {at / 8, at % 8};
}
template <uint32_t bits>
Place highest_first(uint32_t sample, uint32_t bit) {
  const uint32_t at = bits * sample + bits - 1 - bit;
  return {at / 8, 7 - at % 8};
}
Place gige(uint32_t sample, uint32_t bit) {
  return bit >= 4 ? Place{2 * sample, bit - 4} : Place{1, 4 * sample + bit};
}

constexpr Layout layouts[] = {
    {Packing::raw10, 10, mipi<2, 4>},
    {Packing::raw12, 12, mipi<4, 2>},
    {Packing::mono10p, 10, lowest_first<10>},
    {Packing::mono12p, 12, lowest_first<12>},
    {Packing::mono10pmsb, 10, highest_first<10>},
    {Packing::mono12pmsb, 12, highest_first<12>},
    {Packing::mono12_packed, 12, gige},
};

std::vector<uint8_t> packed(const Layout& layout, const std::vector<uint16_t>& samples) {
  const auto count = static_cast<uint32_t>(samples.size());
  const PackedGroup group = group_of(layout.packing);
  std::vector<uint8_t> bytes(packed_bytes(layout.packing, count));
  for (uint32_t i = 0; i < count; ++i)
    for (uint32_t bit = 0; bit < layout.bits; ++bit) {
      const Place place = layout.place(i % group.samples, bit);
      auto& byte = bytes[i / group.samples * group.bytes + place.byte];
      byte = static_cast<uint8_t>(byte | (uint32_t{samples[i]} >> bit & 1U) << place.bit);
    }
  return bytes;
}

std::vector<uint16_t> some_samples(const Layout& layout, uint32_t count) {
  test::Chance chance(count);
  std::vector<uint16_t> samples;
  for (uint32_t i = 0; i < count; ++i)
    samples.push_back(static_cast<uint16_t>(chance.below(1U << layout.bits)));
  return samples;
}

}  // namespace

TEST_CASE("every sample value is unpacked unchanged at every position of a group") {
  for (const Layout& layout : layouts) {
    CAPTURE(static_cast<int>(layout.packing));
    const uint32_t group = group_of(layout.packing).samples;
    bool are_right = true;
    for (uint32_t place = 0; place < group; ++place)
      for (uint32_t value = 0; value < 1U << layout.bits; ++value)
        for (const uint32_t others : {0U, (1U << layout.bits) - 1}) {
          std::vector<uint16_t> samples(group, static_cast<uint16_t>(others));
          samples[place] = static_cast<uint16_t>(value);
          std::vector<uint16_t> unpacked(group);
          unpack(layout.packing, packed(layout, samples).data(), group, unpacked.data());
          are_right = are_right && unpacked == samples;
        }
    CHECK(are_right);
  }
}

TEST_CASE("rows of any width are unpacked, even in place, without writing beyond their end") {
  for (const Layout& layout : layouts)
    for (uint32_t count = 0; count <= 41; ++count) {
      INFO("packing ", static_cast<int>(layout.packing), ", count ", count);
      const std::vector<uint16_t> samples = some_samples(layout, count);
      const std::vector<uint8_t> bytes = packed(layout, samples);
      std::vector<uint16_t> expected = samples;
      expected.resize(count + 8, 0x5A5A);

      std::vector<uint16_t> unpacked(count + 8, 0x5A5A);
      unpack(layout.packing, bytes.data(), count, unpacked.data());
      CHECK(unpacked == expected);

      std::vector<uint16_t> row(count + 8, 0x5A5A);
      auto* const in_place = reinterpret_cast<uint8_t*>(row.data());
      std::copy(bytes.begin(), bytes.end(), in_place);
      unpack(layout.packing, in_place, count, row.data());
      row.resize(count);
      CHECK(row == samples);
    }
}

TEST_CASE("packed_bytes() rounds a row up to whole groups of bytes") {
  CHECK(packed_bytes(Packing::raw10, 0) == 0);
  CHECK(packed_bytes(Packing::raw10, 1) == 5);
  CHECK(packed_bytes(Packing::raw10, 640) == 800);
  CHECK(packed_bytes(Packing::mono10p, 641) == 805);
  CHECK(packed_bytes(Packing::mono12_packed, 640) == 960);
  CHECK(packed_bytes(Packing::raw12, 641) == 963);
}

TEST_CASE("packed samples are unpacked as in the tables of the standards") {
  uint16_t samples[4] = {};
  const uint8_t raw10[] = {0xFF, 0x00, 0x80, 0x01, 0b11100100};
  unpack(Packing::raw10, raw10, 4, samples);
  CHECK(samples[0] == 0x3FC);
  CHECK(samples[1] == 0x001);
  CHECK(samples[2] == 0x202);
  CHECK(samples[3] == 0x007);
  const uint8_t three[] = {0x12, 0x34, 0x56};
  unpack(Packing::raw12, three, 2, samples);
  CHECK(samples[0] == 0x126);
  CHECK(samples[1] == 0x345);
  unpack(Packing::mono12p, three, 2, samples);
  CHECK(samples[0] == 0x412);
  CHECK(samples[1] == 0x563);
  unpack(Packing::mono12pmsb, three, 2, samples);
  CHECK(samples[0] == 0x123);
  CHECK(samples[1] == 0x456);
  unpack(Packing::mono12_packed, three, 2, samples);
  CHECK(samples[0] == 0x124);
  CHECK(samples[1] == 0x563);
}
