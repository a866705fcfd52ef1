// Rows of bits, compared with their definition: the bit of each voxel, its copies and the halo, for
// samples in any portions. The rows around a row stay valid while later rows overwrite the oldest.
#include <discmc/trace/bit_rows.hpp>

#include <random>

#include "oracle/volume.hpp"
#include "test.hpp"

using namespace discmc;
using reference::BitVolume;

namespace {

constexpr uint32_t boundary_widths[] = {1,  2,  3,  27, 28, 29, 30, 31, 32, 33,  57,  58,  59, 60,
                                        61, 62, 63, 88, 89, 90, 91, 92, 93, 119, 120, 121, 150};

// Bit rows in memory of exactly their size.
struct Rows : detail::trace::BitRows {
  std::vector<uint32_t> memory;

  explicit Rows(const Limits& limits)
      : memory(
            detail::trace::bit_row_bytes(limits.width, detail::trace::swept_rows(limits.height)) /
                4,
            0xDEADBEEF) {
    // The vector is aligned, so the bytes for the arena's alignment are not needed.
    Arena arena({memory.data(), sizeof(uint32_t) * memory.size() + Arena::alignment - 1});
    start(arena, limits, detail::trace::swept_rows(limits.height));
    REQUIRE_FALSE(arena.is_exhausted());
    clear();
  }
};

// Compares all bits of a row: bit i of word k is column 30k - 1 + i, and voxel x is column x + 1.
// The first bit is set if any voxel is on.
template <class IsOn>
void check_row(const uint32_t* row, uint32_t width, IsOn is_on) {
  bool is_any_on = false;
  for (uint32_t x = 0; x < width; ++x) is_any_on = is_any_on || is_on(static_cast<int32_t>(x));
  CHECK((row[0] & 1) == (is_any_on ? 1 : 0));
  for (uint32_t bit = 1; bit < 32 * detail::trace::row_words(width); ++bit) {
    const int32_t x = static_cast<int32_t>(bit / 32 * 30 + bit % 32) - 2;
    const bool expected = x >= 0 && x < static_cast<int32_t>(width) && is_on(x);
    if ((row[bit / 32] >> bit % 32 & 1) != expected)
      FAIL("voxel ", x, " of ", width, " is ", !expected, " in bit ", bit % 32, " of word ",
           bit / 32);
  }
}

// Likewise checks the first row, which must be complete.
template <class IsOn>
void check_first_row(const Rows& rows, uint32_t width, IsOn is_on) {
  CHECK(rows.is_row_complete());
  check_row(rows.memory.data(), width, is_on);
}

template <class Sample>
void check_comparison(const std::vector<Sample>& samples, int32_t threshold) {
  CAPTURE(threshold);
  const auto width = static_cast<uint32_t>(samples.size());
  Rows rows({width, 1, Border::closed});
  rows.append(samples.data(), width, 1, threshold);
  check_first_row(rows, width,
                  [&](int32_t x) { return int32_t{samples[static_cast<size_t>(x)]} >= threshold; });
}

void check_around(const Rows& rows, const BitVolume& volume, int32_t y, int32_t z) {
  detail::trace::RowBlock block;
  rows.find_around(y, block);
  for (int32_t k = 0; k < 3; ++k)
    for (int32_t j = 0; j < 3; ++j)
      check_row(block.row[k][j], volume.width,
                [&](int32_t x) { return volume.at(x, y + j - 1, z + k - 1); });
  bool is_off = true;
  for (int32_t x = 0; x < static_cast<int32_t>(volume.width); ++x)
    is_off = is_off && !volume.at(x, y, z) && !volume.at(x, y + 1, z) && !volume.at(x, y, z + 1);
  CHECK(rows.is_off_around(y) == is_off);
}

// Checks the rows that become ready for the sweep with the newest of `count` rows of slice z. Rows
// around older ones are being overwritten.
void check_newest(const Rows& rows, const BitVolume& volume, uint32_t count, int32_t z) {
  const auto newest = static_cast<int32_t>(count) - 2;
  check_around(rows, volume, newest, z - 1);
  if (count == volume.height) check_around(rows, volume, newest + 1, z - 1);
}

constexpr int32_t thresholds_at_ends[] = {
    INT32_MIN, INT32_MIN + 1, -32769, -32768, -32767, -1,    0,     1,
    32767,     32768,         32769,  65535,  65536,  65537, 98304, INT32_MAX};

}  // namespace

TEST_CASE("each word of a row contains 30 columns and copies of both neighbouring columns") {
  const std::vector<uint8_t> on(90, 1);
  Rows rows({90, 1, Border::closed});
  rows.append(on.data(), 90, 1, 1);
  REQUIRE(rows.words() == 4);
  CHECK(rows.memory[0] == 0xFFFFFFFD);  // some are on, but not the halo
  CHECK(rows.memory[1] == 0xFFFFFFFF);
  CHECK(rows.memory[2] == 0xFFFFFFFF);
  CHECK(rows.memory[3] == 0x00000003);  // columns 89 and 90, then the halo
}

TEST_CASE("the neighbours of every row are those of the volume, including the border") {
  for (const uint32_t width : boundary_widths)
    for (const uint32_t height : {1U, 2U, 3U, 5U}) {
      const BitVolume volume = reference::random({width, height, 5}, 128, width * 8 + height);
      Rows rows({width, height, Border::closed});
      // The slice after the last one is off.
      for (int32_t z = 0; z <= 5; ++z) {
        for (uint32_t y = 0; y < height; ++y) {
          CHECK(rows.rows() == y);
          if (z < 5)
            rows.append(&volume.on[volume.index(0, y, z)], width, 1, 1);
          else
            rows.fill_off();
          CHECK(rows.is_row_complete());
          rows.next_row();
          // No samples: the oldest row, which the next row will overwrite, is still in use.
          if (y + 1 < height) rows.append(volume.on.data(), 0, 1, 1);
          check_newest(rows, volume, y + 1, z);
        }
        rows.next_slice();
      }
      CHECK(rows.slices() == 6);
    }
}

TEST_CASE("rows that have not yet arrived are off") {
  const std::vector<uint8_t> on(40, 1);
  Rows rows({40, 3, Border::closed});
  const auto is_on = [](const uint32_t* row) { return row[1] != 0; };
  for (uint32_t i = 0; i < 3 * 3; ++i) {
    if (rows.rows() == 3) rows.next_slice();
    rows.append(on.data(), 40, 1, 1);
    rows.next_row();
    detail::trace::RowBlock block;
    rows.find_around(static_cast<int32_t>(rows.rows()) - 1, block);
    CHECK(is_on(block.row[2][1]));
    CHECK_FALSE(is_on(block.row[2][2]));
    CHECK(is_on(block.row[1][1]) == (rows.slices() >= 1));
    CHECK(is_on(block.row[0][1]) == (rows.slices() >= 2));
  }
}

TEST_CASE("a row of maximal width is stored unchanged") {
  constexpr uint32_t width = Limits::max_extent;
  std::mt19937 random(1);
  std::vector<uint16_t> samples(width);
  for (uint16_t& sample : samples) sample = static_cast<uint16_t>(random());
  check_comparison(samples, 0x8000);
  // Also in two portions, one of them short.
  for (const uint32_t first : {1U, 29999U, width - 1}) {
    Rows rows({width, 1, Border::closed});
    rows.append(samples.data(), first, 1, 0x8000);
    rows.append(samples.data() + first, width - first, 1, 0x8000);
    check_first_row(rows, width,
                    [&](int32_t x) { return samples[static_cast<size_t>(x)] >= 0x8000; });
  }
}

TEST_CASE("a row may arrive in portions of any size") {
  for (const uint32_t width : boundary_widths)
    for (uint32_t chunk = 1; chunk < 70; ++chunk) {
      const BitVolume volume = reference::random({width, 1, 1}, 128, chunk);
      Rows rows({width, 1, Border::closed});
      for (uint32_t at = 0; at < width; at += chunk) {
        const uint32_t count = chunk < width - at ? chunk : width - at;
        CHECK(rows.column() == at);
        // The samples beside the portion have the opposite value.
        std::vector<uint8_t> portion(count + 2);
        for (uint32_t i = 0; i < count + 2; ++i) {
          const bool is_on = volume.at(int64_t{at} + i - 1, 0, 0);
          portion[i] = is_on == (i > 0 && i <= count);
        }
        rows.append(&portion[1], count, 1, 1);
        rows.append(&portion[1], 0, 1, 1);
      }
      check_first_row(rows, width, [&](int32_t x) { return volume.at(x, 0, 0); });
    }
}

TEST_CASE("a row of bits equals the row of its samples") {
  for (const uint32_t width : boundary_widths) {
    const BitVolume volume = reference::random({width, 1, 1}, 128, width);
    std::vector<uint8_t> bits((width + 7) / 8, 0);
    for (uint32_t x = 0; x < width; ++x)
      bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | volume.on[x] << x % 8);
    // Bits beyond the row in the last byte are ignored.
    if (width % 8 != 0) bits.back() = static_cast<uint8_t>(bits.back() | 0xFFU << width % 8);
    Rows rows({width, 1, Border::closed});
    rows.append_bits(bits.data());
    check_first_row(rows, width, [&](int32_t x) { return volume.at(x, 0, 0); });
  }
}

TEST_CASE(
    "fill_off() keeps earlier samples, and repeat() copies the previous row, even across slices") {
  for (const uint32_t width : boundary_widths) {
    BitVolume volume = reference::random({width, 2, 2}, 160, width);
    Rows rows({width, 2, Border::closed});
    const uint32_t half = width / 2;
    // Row 0: half of it arrived; row 1: likewise; next slice: likewise, then none.
    rows.append(volume.on.data(), half, 1, 1);
    rows.fill_off();
    std::fill_n(volume.on.begin() + half, width - half, uint8_t{0});
    CHECK(rows.is_row_complete());
    rows.next_row();
    rows.repeat();
    CHECK(rows.is_row_complete());
    rows.next_row();
    std::copy_n(volume.on.begin(), width, volume.on.begin() + width);
    check_newest(rows, volume, 2, 0);
    rows.next_slice();
    rows.repeat();
    rows.next_row();
    rows.fill_off();
    rows.next_row();
    std::copy_n(volume.on.begin(), width, volume.on.begin() + 2 * width);
    std::fill_n(volume.on.begin() + 3 * width, width, uint8_t{0});
    check_newest(rows, volume, 2, 1);
  }
}

TEST_CASE("repeat() of the first row yields an empty row, even after clear()") {
  const std::vector<uint8_t> on(40, 1);
  const BitVolume off({40, 2, 1});
  Rows rows({40, 2, Border::closed});
  for (int round = 0; round < 2; ++round) {
    rows.repeat();
    rows.next_row();
    check_newest(rows, off, 1, 0);
    for (int i = 0; i < 5; ++i) {
      if (rows.rows() == 2) rows.next_slice();
      rows.append(on.data(), 40, 1, 1);
      rows.next_row();
    }
    rows.append(on.data(), 7, 1, 1);
    rows.clear();
    CHECK(rows.column() == 0);
    CHECK(rows.rows() == 0);
    CHECK(rows.slices() == 0);
  }
}

TEST_CASE("every 8-bit sample is compared correctly with every threshold, for any neighbours") {
  for (int32_t threshold = -1; threshold <= 257; ++threshold)
    for (uint32_t lane = 0; lane < 4; ++lane)
      for (const uint8_t beside : {uint8_t{0}, uint8_t{255}}) {
        std::vector<uint8_t> samples(4 * 256, beside);
        for (uint32_t value = 0; value < 256; ++value)
          samples[4 * value + lane] = static_cast<uint8_t>(value);
        check_comparison(samples, threshold);
      }
}

TEST_CASE_TEMPLATE(
    "16-bit samples are compared correctly with thresholds at the ends of all ranges", Sample,
    uint16_t, int16_t) {
  for (const int32_t threshold : thresholds_at_ends)
    for (const uint32_t odd : {0U, 1U})
      for (const uint32_t beside : {0U, 0x7FFFU, 0x8000U, 0xFFFFU})
        for (uint32_t begin = 0; begin < 0x10000; begin += 0x2000) {
          std::vector<Sample> samples(2 * 0x2000, static_cast<Sample>(beside));
          for (uint32_t i = 0; i < 0x2000; ++i)
            samples[2 * i + odd] = static_cast<Sample>(begin + i);
          check_comparison(samples, threshold);
        }
}

TEST_CASE_TEMPLATE("a row of equal samples is all on or all off", Sample, uint8_t, uint16_t,
                   int16_t) {
  for (int32_t threshold = -1; threshold <= 257; ++threshold)
    for (int32_t value = 0; value < 256; ++value)
      check_comparison(std::vector<Sample>(64, static_cast<Sample>(value)), threshold);
  for (const int32_t threshold : thresholds_at_ends)
    for (const uint32_t value : {0U, 1U, 0x7FFEU, 0x7FFFU, 0x8000U, 0x8001U, 0xFFFEU, 0xFFFFU})
      check_comparison(std::vector<Sample>(64, static_cast<Sample>(value)), threshold);
}

TEST_CASE_TEMPLATE("samples may begin at any address and at any column", Sample, uint8_t, uint16_t,
                   int16_t) {
  constexpr uint32_t width = 200;
  std::mt19937 random(1);
  for (uint32_t place = 0; place < sizeof(uint32_t); ++place)
    for (uint32_t column = 0; column < 32; ++column)
      for (uint32_t count = 0; count <= 130; ++count)
        for (uint32_t stride = 1; stride <= 3; ++stride) {
          // Exactly as many samples as are read, so that sanitizers detect others.
          const uint32_t span = count == 0 ? 0 : (count - 1) * stride + 1;
          const auto memory = std::make_unique<Sample[]>(place + span);
          Sample* const samples = memory.get() + place;
          // Often many equal samples in sequence.
          const uint32_t rarity = 1 + random() % 64;
          const bool most = random() % 2 != 0;
          for (uint32_t i = 0; i < span; ++i)
            samples[i] = (random() % rarity == 0) != most ? Sample{100} : Sample{99};

          const std::vector<uint8_t> off(column, 0);
          Rows rows({width, 1, Border::closed});
          rows.append(off.data(), column, 1, 1);
          rows.append(samples, count, stride, 100);
          CHECK(rows.column() == column + count);
          rows.fill_off();
          INFO("place ", place, ", column ", column, ", count ", count, ", stride ", stride);
          check_first_row(rows, width, [&](int32_t x) {
            const uint32_t i = static_cast<uint32_t>(x) - column;
            return i < count && samples[i * stride] >= 100;
          });
        }
}

TEST_CASE_TEMPLATE("a row ends at its last sample, even before further samples that are off",
                   Sample, uint8_t, uint16_t, int16_t) {
  constexpr uint32_t width = 150;
  const std::vector<Sample> samples(2 * width, Sample{0});
  for (uint32_t count = 1; count <= width; ++count) {
    Rows rows({width, 1, Border::closed});
    rows.append(samples.data(), count, 1, 1);
    REQUIRE(rows.column() == count);
  }
}

TEST_CASE("a row is written as bits, and bits beyond its width are off") {
  for (const uint32_t width : boundary_widths) {
    CAPTURE(width);
    const Limits limits{width, 2, Border::closed};
    std::mt19937 random(width);
    Rows rows(limits);
    std::vector<uint8_t> bits((width + 7) / 8, 0xFF), written(bits.size() + 1, 0x5A);
    // The rows around it are on.
    for (uint32_t row = 0; row < detail::trace::swept_rows(limits.height) + 2; ++row) {
      rows.append_bits(bits.data());
      rows.next_row();
    }
    for (uint8_t& byte : bits) byte = static_cast<uint8_t>(random());
    bits.back() = 0xFF;
    rows.append_bits(bits.data());
    rows.write_bits(written.data());
    bits.back() = static_cast<uint8_t>(0xFF >> (8 * bits.size() - width));
    bits.push_back(0x5A);  // and the words behind it stay unchanged
    CHECK(written == bits);
  }
}

TEST_CASE_TEMPLATE("a single on sample is found in a short row, for any preceding samples", Sample,
                   uint8_t, uint16_t, int16_t) {
  constexpr uint32_t width = 31;
  for (uint32_t place = 0; place < width; ++place) {
    std::vector<Sample> samples(64 + width, 0);
    samples[64 + place] = 100;
    Rows rows({width, 1, Border::closed});
    rows.append(samples.data() + 64, width, 1, 100);
    check_first_row(rows, width, [&](int32_t x) { return x == static_cast<int32_t>(place); });
  }
}
