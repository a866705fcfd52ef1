#include <discmc/front/packed_samples.hpp>

#include <discmc/base/compiler.hpp>

namespace discmc {
namespace {

// Per layout: sample i of a group in the lowest bits, perhaps with other bits above.

struct Raw10 {
  static constexpr uint32_t bits = 10, group = 4, bytes = 5;
  static constexpr uint32_t sample(const uint8_t (&byte)[bytes], uint32_t i) {
    return uint32_t{byte[i]} << 2 | (uint32_t{byte[4]} >> 2 * i & 3);
  }
};

struct Raw12 {
  static constexpr uint32_t bits = 12, group = 2, bytes = 3;
  static constexpr uint32_t sample(const uint8_t (&byte)[bytes], uint32_t i) {
    return uint32_t{byte[i]} << 4 | (uint32_t{byte[2]} >> 4 * i & 15);
  }
};

// No sample of 10 or 12 bits lies in more than two bytes.
template <uint32_t sample_bits, uint32_t samples>
struct LowestFirst {
  static constexpr uint32_t bits = sample_bits, group = samples, bytes = bits * group / 8;
  static constexpr uint32_t sample(const uint8_t (&byte)[bytes], uint32_t i) {
    const uint32_t first = i * bits / 8;
    return (byte[first] | uint32_t{byte[first + 1]} << 8) >> i * bits % 8;
  }
};

template <uint32_t sample_bits, uint32_t samples>
struct HighestFirst {
  static constexpr uint32_t bits = sample_bits, group = samples, bytes = bits * group / 8;
  static constexpr uint32_t sample(const uint8_t (&byte)[bytes], uint32_t i) {
    const uint32_t first = i * bits / 8;
    return (uint32_t{byte[first]} << 8 | byte[first + 1]) >> (16 - bits - i * bits % 8);
  }
};

// The lowest bits of both samples are in the byte between them.
struct Mono12Packed {
  static constexpr uint32_t bits = 12, group = 2, bytes = 3;
  static constexpr uint32_t sample(const uint8_t (&byte)[bytes], uint32_t i) {
    const uint32_t highest = 2 * i;
    return uint32_t{byte[highest]} << 4 | (uint32_t{byte[1]} >> 4 * i & 15);
  }
};

template <class Layout>
void unpack_group(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  uint8_t byte[Layout::bytes];
  DISCMC_UNROLL(5)
  for (uint32_t i = 0; i < Layout::bytes; ++i) byte[i] = packed[i];
  DISCMC_UNROLL(4)
  for (uint32_t i = 0; i < Layout::group; ++i)
    if (i < count)
      samples[i] =
          static_cast<uint16_t>(Layout::sample(byte, i) & ((uint32_t{1} << Layout::bits) - 1));
}

// From the last group to the first: in place, each group is written after all unread bytes, and
// read before it is written.
template <class Layout>
void unpack_row(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  const uint32_t groups = count / Layout::group;
  const uint32_t left = count % Layout::group;
  packed += groups * Layout::bytes;
  samples += groups * Layout::group;
  if (left > 0) unpack_group<Layout>(packed, left, samples);
  for (uint32_t group = groups; group > 0; --group) {
    packed -= Layout::bytes;
    samples -= Layout::group;
    unpack_group<Layout>(packed, Layout::group, samples);
  }
}

}  // namespace

void detail::unpacking::raw10(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<Raw10>(packed, count, samples);
}
void detail::unpacking::raw12(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<Raw12>(packed, count, samples);
}
void detail::unpacking::mono10p(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<LowestFirst<10, 4>>(packed, count, samples);
}
void detail::unpacking::mono12p(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<LowestFirst<12, 2>>(packed, count, samples);
}
void detail::unpacking::mono10pmsb(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<HighestFirst<10, 4>>(packed, count, samples);
}
void detail::unpacking::mono12pmsb(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<HighestFirst<12, 2>>(packed, count, samples);
}
void detail::unpacking::mono12_packed(const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack_row<Mono12Packed>(packed, count, samples);
}

}  // namespace discmc
