// Rows of bits against a naive model: which voxels are on, which cells are active, and what lies
// around a row of cells while the next slice overwrites the last.
#include <doctest/doctest.h>
#include <discmc/slice.hpp>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "oracle/volume.hpp"

using namespace discmc;
using reference::BitVolume;

namespace {

constexpr uint32_t boundary_widths[] = {1,  2,  3,  29, 30, 31, 32, 33,  34,  61,  62,  63, 64,
                                        65, 66, 95, 96, 97, 98, 99, 126, 127, 128, 129, 130};

// Bit rows in memory of exactly their size.
struct Rows {
  std::vector<uint32_t> words;
  BitRows rows;
  uint32_t halo;

  explicit Rows(const Limits& limits)
      : words(size_t{limits.row_words()} * (limits.height + 3), 0xDEADBEEF), halo(limits.halo()) {
    // The vector is aligned, so what the arena sets aside for that is not needed.
    Arena arena({words.data(), sizeof(uint32_t) * words.size() + Arena::alignment - 1});
    rows.start(arena, limits);
    REQUIRE_FALSE(arena.is_exhausted());
    rows.clear();
  }

  bool bit(const uint32_t* row, uint32_t i) const { return (row[i / 32] >> i % 32 & 1) != 0; }
};

// Whether voxel x (which may be in the halo) of a row around a row of cells is on.
bool expected_bit(const BitVolume& volume, const Limits& limits, uint32_t bit, int64_t y,
                  int64_t z) {
  return volume.at(int64_t{bit} - limits.halo(), y, z);
}

// Calls check(y) for the rows of cells that can be swept now that `rows_so_far` rows of voxels are
// there, and could not before: older ones are being overwritten.
template <class Check>
void for_each_new_row_of_cells(const Limits& limits, uint32_t rows_so_far, Check check) {
  const int64_t halo = limits.halo();
  const int64_t newest = int64_t{rows_so_far} - 2;
  if (newest >= -halo) check(newest);
  if (rows_so_far == limits.height && halo == 1) check(newest + 1);
}

// The rows around the newest row of cells of the layer below slice z.
void check_newest(const Rows& rows, const BitVolume& volume, const Limits& limits, int64_t z,
                  uint32_t rows_so_far) {
  for_each_new_row_of_cells(limits, rows_so_far, [&](int64_t y) {
    const RowQuad quad = rows.rows.around(static_cast<int32_t>(y));
    for (uint32_t i = 0; i < 4; ++i)
      for (uint32_t bit = 0; bit < 32 * limits.row_words(); ++bit)
        if (rows.bit(quad.row[i], bit) !=
            expected_bit(volume, limits, bit, y + i % 2, z - 1 + i / 2))
          FAIL("another bit in row ", y + i % 2, " of slice ", z - 1 + i / 2, " at ", bit);
  });
}

void check_cells(const Rows& rows, const BitVolume& volume, const Limits& limits, int64_t y,
                 int64_t z) {
  const RowQuad quad = rows.rows.around(static_cast<int32_t>(y));
  const uint32_t words = limits.row_words();
  for (uint32_t column = 0; column < limits.columns(); ++column) {
    const auto x = static_cast<int32_t>(column) - static_cast<int32_t>(limits.halo());
    const Configuration expected =
        volume.configuration({x, static_cast<int32_t>(y), static_cast<int32_t>(z)});
    CHECK(configuration_at(quad, column / 32, column % 32) == expected);
    const bool is_active = (active_cells(quad, column / 32, words) >> column % 32 & 1) != 0;
    CHECK(is_active == (expected != 0 && expected != 255));
  }
}

constexpr int32_t thresholds_at_ends[] = {
    INT32_MIN, INT32_MIN + 1, -32769, -32768, -32767, -1,    0,     1,
    32767,     32768,         32769,  65535,  65536,  65537, 98304, INT32_MAX};

// Appends the samples as a row and compares every voxel with the definition.
template <class Sample>
void check_comparison(const std::vector<Sample>& samples, int32_t threshold) {
  const auto width = static_cast<uint32_t>(samples.size());
  Rows rows({width, 1, Border::open});
  rows.rows.append(samples.data(), width, 1, threshold);
  for (uint32_t i = 0; i < width; ++i)
    if (rows.bit(rows.words.data(), i) != (int32_t{samples[i]} >= threshold))
      FAIL("sample ", samples[i], " and threshold ", threshold, " at ", i);
}

}  // namespace

TEST_CASE("the rows around every row of cells are those of the volume, halo and all") {
  for (const uint32_t width : boundary_widths)
    for (const uint32_t height : {1U, 2U, 3U, 5U})
      for (const Border border : {Border::closed, Border::open}) {
        const Limits limits{width, height, border};
        const BitVolume volume = reference::random({width, height, 5}, 128, width * 8 + height);
        Rows rows(limits);
        for (uint32_t z = 0; z < 5; ++z) {
          for (uint32_t y = 0; y < height; ++y) {
            rows.rows.append(&volume.on[volume.index(0, y, z)], width, 1, 1);
            CHECK(rows.rows.row_is_complete());
            rows.rows.next_row();
            // No samples: the old row whose place the next row takes is still in use.
            if (y + 1 < height) rows.rows.append(volume.on.data(), 0, 1, 1);
            check_newest(rows, volume, limits, z, y + 1);
          }
          rows.rows.next_slice();
        }
        CHECK(rows.rows.slices() == 5);
      }
}

TEST_CASE("cells are active and have their configuration as the volume says") {
  for (const uint32_t width : boundary_widths)
    for (const uint32_t density : {20U, 128U, 240U})
      for (const Border border : {Border::closed, Border::open}) {
        const Limits limits{width, 3, border};
        const BitVolume volume = reference::random({width, 3, 2}, density, width);
        Rows rows(limits);
        for (uint32_t z = 0; z < 2; ++z) {
          for (uint32_t y = 0; y < 3; ++y) {
            rows.rows.append(&volume.on[volume.index(0, y, z)], width, 1, 1);
            rows.rows.next_row();
            if (z == 0 && border == Border::open) continue;
            for_each_new_row_of_cells(limits, y + 1, [&](int64_t cells) {
              check_cells(rows, volume, limits, cells, int64_t{z} - 1);
            });
          }
          rows.rows.next_slice();
        }
      }
}

TEST_CASE("a row may arrive in any portions") {
  for (const uint32_t width : {1U, 31U, 33U, 65U, 100U})
    for (uint32_t chunk = 1; chunk < 70; chunk += 3) {
      const Limits limits{width, 1, Border::closed};
      const BitVolume volume = reference::random({width, 1, 1}, 128, chunk);
      Rows rows(limits);
      for (uint32_t at = 0; at < width; at += chunk) {
        const uint32_t count = chunk < width - at ? chunk : width - at;
        CHECK(rows.rows.column() == at);
        rows.rows.append(volume.on.data() + at, count, 1, 1);
        rows.rows.append(volume.on.data() + at, 0, 1, 1);
      }
      rows.rows.next_row();
      check_newest(rows, volume, limits, 0, 1);
    }
}

TEST_CASE("a row of bits is the same as its samples") {
  for (const uint32_t width : boundary_widths)
    for (const Border border : {Border::closed, Border::open}) {
      const Limits limits{width, 2, border};
      const BitVolume volume = reference::random({width, 2, 1}, 128, width);
      Rows rows(limits);
      for (uint32_t y = 0; y < 2; ++y) {
        std::vector<uint8_t> bits((width + 7) / 8, 0);
        for (uint32_t x = 0; x < width; ++x)
          bits[x / 8] =
              static_cast<uint8_t>(bits[x / 8] | volume.on[volume.index(x, y, 0)] << x % 8);
        if (width % 8 != 0) bits.back() = static_cast<uint8_t>(bits.back() | 0xFFU << width % 8);
        rows.rows.append_bits(bits.data());
        CHECK(rows.rows.row_is_complete());
        rows.rows.next_row();
      }
      check_newest(rows, volume, limits, 0, 2);
    }
}

TEST_CASE("fill_off keeps what has come, repeat takes the row before, of the last slice too") {
  for (const uint32_t width : boundary_widths) {
    const Limits limits{width, 2, Border::closed};
    BitVolume volume = reference::random({width, 2, 2}, 160, width);
    Rows rows(limits);
    const uint32_t half = width / 2;
    // Row 0: half of it came; row 1: the same again; next slice: again, then none at all.
    rows.rows.append(volume.on.data(), half, 1, 1);
    rows.rows.fill_off();
    for (uint32_t x = half; x < width; ++x) volume.on[x] = 0;
    CHECK(rows.rows.row_is_complete());
    rows.rows.next_row();
    rows.rows.repeat();
    CHECK(rows.rows.row_is_complete());
    rows.rows.next_row();
    std::copy_n(volume.on.begin(), width, volume.on.begin() + width);
    check_newest(rows, volume, limits, 0, 2);
    rows.rows.next_slice();
    rows.rows.repeat();
    rows.rows.next_row();
    rows.rows.fill_off();
    rows.rows.next_row();
    std::copy_n(volume.on.begin(), width, volume.on.begin() + 2 * width);
    std::fill_n(volume.on.begin() + 3 * width, width, uint8_t{0});
    check_newest(rows, volume, limits, 1, 2);
  }
}

TEST_CASE("the very first row repeats the nothing before it, after clear too") {
  const Limits limits{40, 2, Border::closed};
  const std::vector<uint8_t> on(40, 1);
  Rows rows(limits);
  for (int round = 0; round < 2; ++round) {
    rows.rows.repeat();
    rows.rows.next_row();
    const BitVolume off({40, 2, 1});
    check_newest(rows, off, limits, 0, 1);
    for (int i = 0; i < 5; ++i) {
      if (rows.rows.rows() == 2) rows.rows.next_slice();
      rows.rows.append(on.data(), 40, 1, 1);
      rows.rows.next_row();
    }
    rows.rows.clear();
    CHECK(rows.rows.column() == 0);
    CHECK(rows.rows.rows() == 0);
    CHECK(rows.rows.slices() == 0);
  }
}

TEST_CASE("every sample of 8 bits compares with every threshold, whatever lies beside it") {
  for (int32_t threshold = -1; threshold <= 257; ++threshold)
    for (uint32_t lane = 0; lane < 4; ++lane)
      for (const uint8_t beside : {uint8_t{0}, uint8_t{255}}) {
        std::vector<uint8_t> samples(4 * 256, beside);
        for (uint32_t value = 0; value < 256; ++value)
          samples[4 * value + lane] = static_cast<uint8_t>(value);
        check_comparison(samples, threshold);
      }
}

TEST_CASE_TEMPLATE("samples of 16 bits compare with the thresholds at the ends of all ranges",
                   Sample, uint16_t, int16_t) {
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

TEST_CASE_TEMPLATE("a row of equal samples is on as a whole or off as a whole", Sample, uint8_t,
                   uint16_t, int16_t) {
  for (int32_t threshold = -1; threshold <= 257; ++threshold)
    for (int32_t value = 0; value < 256; ++value)
      check_comparison(std::vector<Sample>(64, static_cast<Sample>(value)), threshold);
  for (const int32_t threshold : thresholds_at_ends)
    for (const uint32_t value : {0U, 1U, 0x7FFEU, 0x7FFFU, 0x8000U, 0x8001U, 0xFFFEU, 0xFFFFU})
      check_comparison(std::vector<Sample>(64, static_cast<Sample>(value)), threshold);
}

TEST_CASE_TEMPLATE("samples may lie anywhere in memory and go anywhere in a row", Sample, uint8_t,
                   uint16_t, int16_t) {
  std::mt19937 random(1);
  for (uint32_t place = 0; place < sizeof(uint32_t); ++place)
    for (uint32_t column = 0; column < 32; ++column)
      for (uint32_t count = 0; count <= 70; ++count)
        for (uint32_t stride = 1; stride <= 3; ++stride) {
          // Not a sample more than are read, so that sanitizers notice; few of them are on.
          const uint32_t span = count == 0 ? 0 : (count - 1) * stride + 1;
          const auto memory = std::make_unique<Sample[]>(place + span);
          Sample* const samples = memory.get() + place;
          for (uint32_t i = 0; i < span; ++i)
            samples[i] = static_cast<Sample>(random() % 64 == 0 ? 100 : random() % 64);

          std::vector<bool> expected(100, false);
          for (uint32_t i = 0; i < count && column + i < 100; ++i)
            expected[column + i] = samples[i * stride] >= 100;
          const std::vector<uint8_t> off(column, 0);
          Rows rows({102, 1, Border::open});
          rows.rows.append(off.data(), column, 1, 1);
          rows.rows.append(samples, count, stride, 100);
          CHECK(rows.rows.column() == column + count);
          if (column + count == 0) continue;
          for (uint32_t i = 0; i < 100; ++i)
            if (rows.bit(rows.words.data(), i) != expected[i])
              FAIL("voxel ", i, " of ", count, " from ", column, ", place ", place, ", stride ",
                   stride);
        }
}

TEST_CASE("the cells that are skipped are not active") {
  constexpr uint32_t words = 4;
  for (uint32_t on = 0; on <= 4 * 32 * words; ++on) {
    uint32_t bits[4][words] = {};
    if (on < 4 * 32 * words) bits[on % 4][on / 128] = uint32_t{1} << on / 4 % 32;
    const RowQuad quad = {{bits[0], bits[1], bits[2], bits[3]}};
    for (uint32_t begin = 0; begin <= words; ++begin) {
      const uint32_t found = skip_off(quad, begin, words);
      for (uint32_t word = begin; word < found; ++word) CHECK(active_cells(quad, word, words) == 0);
      // And no word is found in vain but the one before a word that is on.
      if (found < words) CHECK((on / 128 == found || on / 128 == found + 1));
    }
  }
}
