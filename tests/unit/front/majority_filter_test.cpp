// The majority filter, compared with one that counts voxel by voxel.
#include <discmc/front/majority_filter.hpp>

#include "oracle/scan.hpp"
#include "oracle/volume.hpp"
#include "test.hpp"

namespace {

using discmc::Limits;
using discmc::MajorityFilter;
using discmc::Status;
using discmc::reference::BitVolume;
using discmc::reference::Block;

BitVolume counted(const BitVolume& volume) {
  BitVolume result({volume.width, volume.height, volume.depth});
  const auto inside = [](std::int64_t at, std::uint32_t extent) {
    return std::clamp<std::int64_t>(at, 0, std::int64_t{extent} - 1);
  };
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < volume.depth; ++z)
    for (std::int64_t y = 0; y < volume.height; ++y)
      for (std::int64_t x = 0; x < volume.width; ++x) {
        int on = 0;
        for (int neighbour = 0; neighbour < 27; ++neighbour)
          on += volume.at(inside(x + neighbour % 3 - 1, volume.width),
                          inside(y + neighbour / 3 % 3 - 1, volume.height),
                          inside(z + neighbour / 9 - 1, volume.depth))
                    ? 1
                    : 0;
        result.on[voxel++] = on >= 14 ? 1 : 0;
      }
  return result;
}

BitVolume filtered(const BitVolume& volume, MajorityFilter& filter) {
  const Limits limits{volume.width, volume.height};
  Block block(MajorityFilter::bytes_for(limits));
  REQUIRE(filter.start(limits, block.memory()) == Status::ok);
  BitVolume result({volume.width, volume.height, volume.depth});
  std::size_t rows = 0;
  const auto keep = [&](const std::uint8_t* row) {
    for (std::uint32_t x = 0; x < volume.width; ++x)
      result.on[rows * volume.width + x] = row[x / 8] >> x % 8 & 1;
    for (std::uint32_t x = volume.width; x < (volume.width + 7) / 8 * 8; ++x)
      CHECK((row[x / 8] >> x % 8 & 1) == 0);
    ++rows;
  };
  for (std::size_t row = 0; row < std::size_t{volume.height} * volume.depth; ++row) {
    // Unused bits are ignored.
    std::vector<std::uint8_t> bits((volume.width + 7) / 8, 0xFF);
    for (std::uint32_t x = 0; x < volume.width; ++x)
      if (volume.on[row * volume.width + x] == 0)
        bits[x / 8] = static_cast<std::uint8_t>(bits[x / 8] & ~(1U << x % 8));
    if (const std::uint8_t* due = filter.push(bits.data())) keep(due);
    CHECK(rows == (row > volume.height ? row - volume.height : 0));
  }
  while (const std::uint8_t* due = filter.drain()) keep(due);
  CHECK(rows == std::size_t{volume.height} * volume.depth);
  CHECK(block.is_intact());
  return result;
}

BitVolume filtered(const BitVolume& volume) {
  MajorityFilter filter;
  return filtered(volume, filter);
}

}  // namespace

TEST_CASE("a voxel is on if at least 14 of its 27 neighbours are on, for any size") {
  std::uint32_t seed = 0;
  for (const std::uint32_t width : {1U, 2U, 7U, 8U, 31U, 32U, 33U, 64U, 70U})
    for (const std::uint32_t height : {1U, 2U, 5U})
      for (const std::uint32_t depth : {1U, 2U, 3U, 6U}) {
        INFO(width, " x ", height, " x ", depth);
        const BitVolume volume = discmc::reference::random({width, height, depth}, 128, ++seed);
        CHECK(filtered(volume).on == counted(volume).on);
      }
}

TEST_CASE("a majority filter preserves full volumes and walls and removes specks") {
  const BitVolume all = discmc::reference::box({9, 8, 7}, {0, 0, 0}, {8, 7, 6});
  CHECK(filtered(all).on == all.on);
  const BitVolume half = discmc::reference::box({40, 8, 7}, {0, 0, 0}, {19, 7, 6});
  CHECK(filtered(half).on == half.on);
  const BitVolume speck = discmc::reference::box({9, 9, 9}, {3, 3, 3}, {4, 4, 4});
  const BitVolume filtered_speck = filtered(speck);
  CHECK(std::count(filtered_speck.on.begin(), filtered_speck.on.end(), 1) == 0);
}

TEST_CASE("a majority filter refuses invalid limits and too little memory") {
  MajorityFilter filter;
  const Limits limits{33, 4};
  Block block(MajorityFilter::bytes_for(limits) - 1);
  CHECK(filter.start(limits, block.memory()) == Status::too_little_memory);
  CHECK(filter.start({0, 4}, block.memory()) == Status::bad_limits);
}

TEST_CASE("a restarted filter is independent of the previous volume") {
  const Limits limits{10, 3};
  Block block(MajorityFilter::bytes_for(limits));
  MajorityFilter filter;
  const std::uint8_t on[] = {0xFF, 0x03}, off[] = {0, 0};
  for (int start = 0; start < 2; ++start) {
    REQUIRE(filter.start(limits, block.memory()) == Status::ok);
    for (int row = 0; row < 3; ++row) CHECK(filter.push(start == 0 ? on : off) == nullptr);
    int rows = 0;
    for (; const std::uint8_t* due = filter.drain(); ++rows)
      CHECK(due[0] == (start == 0 ? 0xFF : 0));
    CHECK(rows == 3);
  }
}

TEST_CASE("a filter restarted in the middle or at the end of a volume begins a new volume") {
  const BitVolume volume = discmc::reference::random({10, 3, 4}, 128, 1);
  const Limits limits{10, 3};
  const std::uint8_t on[] = {0xFF, 0x03};
  for (int pushed = 0; pushed <= 9; ++pushed)
    for (const bool is_drained : {false, true}) {
      INFO("pushed ", pushed, ", is_drained ", is_drained);
      Block block(MajorityFilter::bytes_for(limits));
      MajorityFilter filter;
      REQUIRE(filter.start(limits, block.memory()) == Status::ok);
      for (int row = 0; row < pushed; ++row) (void)filter.push(on);
      while (is_drained && filter.drain() != nullptr) continue;
      CHECK(filtered(volume, filter).on == counted(volume).on);
    }
}

TEST_CASE("a majority filter needs two slices and four rows, and writes only the row that is due") {
  const Limits limits{33, 2};
  constexpr std::size_t row_bytes = 8;
  REQUIRE(MajorityFilter::bytes_for(limits) ==
          (2 * 2 + 4) * row_bytes + 3 + 2 * discmc::red_zone_bytes);
  const std::uint8_t on[] = {0xFF, 0xFF, 0xFF, 0xFF, 0x01};
  std::vector<std::uint8_t> memory(MajorityFilter::bytes_for(limits) + 16, 0x5A);
  MajorityFilter filter;
  REQUIRE(filter.start(limits, {memory.data(), memory.size()}) == Status::ok);
  for (int row = 0; row < 4; ++row) (void)filter.push(on);
  const std::uint8_t* const due = filter.drain();
  REQUIRE(due != nullptr);
  CHECK(due[4] == 0x01);
  // A red zone in checked builds.
  if (discmc::red_zone_bytes == 0) CHECK(due[row_bytes] == 0x5A);
}
