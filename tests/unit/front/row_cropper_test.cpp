// The rows and samples of a crop, compared with a choice voxel by voxel.
#include <discmc/front/row_cropper.hpp>

#include "oracle/volume.hpp"
#include "test.hpp"

using namespace discmc;

namespace {

constexpr uint32_t rest = CropRange::rest;

bool is_picked(const CropRange& range, uint32_t at, uint32_t count) {
  return at >= range.first && (at - range.first) % range.step == 0 &&
         (at - range.first) / range.step < count;
}

// Counts the chosen voxels.
uint32_t counted(const CropRange& range, uint32_t extent) {
  uint32_t count = 0;
  for (uint32_t at = range.first; at < extent; at += range.step) ++count;
  return range.count == rest ? count : range.count;
}

std::vector<uint8_t> picked_bits(const RowCropper& cropper, const uint8_t* on, uint32_t width,
                                 bool is_in_place) {
  std::vector<uint8_t> bits((width + 7) / 8);
  for (uint32_t x = 0; x < width; ++x)
    bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | on[x] << x % 8);
  std::vector<uint8_t> picked((cropper.count() + 7) / 8, 0x5A);
  cropper.crop_bits(bits.data(), is_in_place ? bits.data() : picked.data());
  if (is_in_place) picked.assign(bits.begin(), bits.begin() + (cropper.count() + 7) / 8);
  std::vector<uint8_t> voxels;
  for (uint32_t x = 0; x < 8 * picked.size(); ++x) voxels.push_back(picked[x / 8] >> x % 8 & 1);
  return voxels;
}

void check(const CropRange& x, const CropRange& y, const CropRange& z) {
  const reference::BitVolume volume = reference::random({19, 7, 6}, 128, 1);
  RowCropper cropper;
  REQUIRE(cropper.start({5, 9}, {}, {}, {}) == Status::ok);
  for (uint32_t row = 0; row < 4; ++row) CHECK(cropper.next());  // another scan, abandoned
  REQUIRE(cropper.start({19, 7, Border::open}, x, y, z) == Status::ok);
  const Limits limits = cropper.limits();
  CHECK(limits.width == counted(x, 19));
  CHECK(limits.height == counted(y, 7));
  CHECK(limits.border == Border::open);
  const uint32_t slices = counted(z, 6);
  uint32_t left = slices * limits.height;
  for (uint32_t row = 0; row < 7 * 6; ++row) {
    const bool is_wanted = is_picked(y, row % 7, limits.height) && is_picked(z, row / 7, slices);
    CHECK(cropper.next() == is_wanted);
    if (is_wanted) --left;
    if (z.count != rest) CHECK(cropper.is_done() == (left == 0 && (row + 1) % 7 == 0));
    const uint8_t* const on = &volume.on[size_t{row} * 19];
    std::vector<uint8_t> expected;
    for (uint32_t at = 0; at < 19; ++at)
      if (is_picked(x, at, limits.width)) expected.push_back(on[at]);
    std::vector<uint8_t> samples;
    for (uint32_t i = 0; i < cropper.count(); ++i)
      samples.push_back(on[cropper.first() + i * cropper.step()]);
    CHECK(samples == expected);
    expected.resize((expected.size() + 7) / 8 * 8);  // unused bits are off
    CHECK(picked_bits(cropper, on, 19, false) == expected);
    CHECK(picked_bits(cropper, on, 19, true) == expected);
  }
  CHECK(left == 0);
}

}  // namespace

TEST_CASE("a cropper picks rows and samples by range and step on each axis") {
  const CropRange ranges[] = {{},           {0, 3, 1},    {2, rest, 1}, {1, 2, 2},
                              {0, rest, 2}, {1, rest, 3}, {5, 1, 7},    {0, rest, 40}};
  for (const CropRange& x : ranges)
    for (const CropRange& y : ranges)
      for (const CropRange& z : ranges) check(x, y, z);
}

TEST_CASE("a cropper without a number of slices accepts any number of slices") {
  RowCropper cropper;
  REQUIRE(cropper.start({4, 2}, {}, {1}, {1, rest, 2}) == Status::ok);
  for (uint32_t row = 0; row < 1000; ++row) {
    CHECK(cropper.next() == (row % 2 == 1 && row / 2 % 2 == 1));
    CHECK_FALSE(cropper.is_done());
  }
}

TEST_CASE("a refused start of a cropper with ranges outside the volume changes nothing") {
  RowCropper cropper;
  REQUIRE(cropper.start({4, 2}, {}, {}, {}) == Status::ok);
  const CropRange refused[] = {{4},    {5},    {4, rest, 2}, {0, 5},
                               {3, 2}, {0, 0}, {0, rest, 0}, {1, 3, 2}};
  for (const CropRange& range : refused) {
    CHECK(cropper.start({4, 4}, range, {}, {}) == Status::bad_limits);
    CHECK(cropper.start({4, 4}, {}, range, {}) == Status::bad_limits);
  }
  CHECK(cropper.start({4, 4}, {}, {}, {0, 0}) == Status::bad_limits);
  CHECK(cropper.start({4, 4}, {}, {}, {0, rest, 0}) == Status::bad_limits);
  CHECK(cropper.start({0, 4}, {}, {}, {}) == Status::bad_limits);
  CHECK(cropper.limits().height == 2);
  CHECK(cropper.next());
}
