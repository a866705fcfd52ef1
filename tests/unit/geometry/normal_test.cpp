// Unit vectors in integers, against double precision.
#include <discmc/chain.hpp>
#include <discmc/normal.hpp>
#include <discmc/polygon.hpp>

#include "oracle/angle.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using discmc::reference::degrees_between;
using discmc::test::Chance;

namespace {

using Direction3 = std::array<double, 3>;

Direction3 direction_of(const LongVector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
Direction3 direction_of(const UnitNormal& n) {
  return {double{n.x * 1.0}, double{n.y * 1.0}, double{n.z * 1.0}};
}

double length(const Direction3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

// A vector with components of up to `bits` bits, each of any size and sign.
LongVector vector_of(Chance& chance, uint32_t bits) {
  const auto component = [&] {
    const auto size = static_cast<int64_t>(chance.next() >> (64 - 1 - chance.below(bits)));
    return chance.below(2) == 0 ? size : -size;
  };
  return {component(), component(), component()};
}

bool is_zero(const LongVector& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

}  // namespace

TEST_CASE("a unit normal deviates at most 0.006 degrees and has unit length") {
  Chance chance(1);
  double worst = 0, worst_length = 0;
  const auto check = [&](const LongVector& v) {
    if (is_zero(v)) return;
    const UnitNormal n = unit_normal(v);
    worst = std::max(worst, degrees_between(direction_of(n), direction_of(v)));
    worst_length = std::max(worst_length, std::fabs(length(direction_of(n)) / 16384 - 1));
  };
  for (int64_t z = -20; z <= 20; ++z)
    for (int64_t y = -20; y <= 20; ++y)
      for (int64_t x = -20; x <= 20; ++x) check({x, y, z});
  for (int i = 0; i < 1000000; ++i) check(vector_of(chance, 62));
  CHECK(worst > 0.001);  // otherwise no case was measured
  CHECK(worst < 0.006);
  CHECK(worst_length < 1e-4);
}

TEST_CASE("normals along axes are exact, and opposite directions have opposite normals") {
  CHECK(unit_normal(LongVector{0, 0, 7}) == UnitNormal{0, 0, 16384});
  CHECK(unit_normal(LongVector{-1, 0, 0}) == UnitNormal{-16384, 0, 0});
  CHECK(unit_normal(LongVector{0, INT64_MAX, 0}) == UnitNormal{0, 16384, 0});
  CHECK(unit_normal(LongVector{0, INT64_MIN, 0}) == UnitNormal{0, -16384, 0});
  Chance chance(2);
  for (int i = 0; i < 10000; ++i) {
    const LongVector v = vector_of(chance, 40);
    const UnitNormal n = unit_normal(v);
    REQUIRE(unit_normal(LongVector{-v.x, -v.y, -v.z}) == UnitNormal{static_cast<int16_t>(-n.x),
                                                                    static_cast<int16_t>(-n.y),
                                                                    static_cast<int16_t>(-n.z)});
  }
}

TEST_CASE("vectors of one direction have the same normal, for any length") {
  CHECK(unit_normal(LongVector{1, 1, 1}) == unit_normal(LongVector{2, 2, 2}));
  CHECK(unit_normal(LongVector{1, -2, 3}) == unit_normal(LongVector{1 << 20, -(1 << 21), 3 << 20}));
}

TEST_CASE("a vector of length zero has no normal") {
  CHECK(unit_normal(LongVector{0, 0, 0}) == UnitNormal{0, 0, 0});
  CHECK(octahedral_normal({0, 0, 0}).is_none());
  CHECK(unit_normal(OctahedralNormal{0, 0}) == UnitNormal{0, 0, 0});
}

TEST_CASE(
    "an octahedral normal deviates by less than 0.96 degrees, and in the median by less than "
    "0.33") {
  Chance chance(3);
  std::vector<double> angles;
  for (int i = 0; i < 300000; ++i) {
    const LongVector v = vector_of(chance, 20);
    if (is_zero(v)) continue;
    const OctahedralNormal n = octahedral_normal(v);
    REQUIRE(!n.is_none());
    angles.push_back(degrees_between(direction_of(unit_normal(n)), direction_of(v)));
  }
  std::sort(angles.begin(), angles.end());
  CHECK(angles.back() > 0.5);
  CHECK(angles.back() < 0.96);
  CHECK(angles[angles.size() / 2] < 0.33);
}

TEST_CASE("directions on the octahedron's rim and straight down have one encoding each") {
  CHECK(octahedral_normal({0, 0, 1}) == OctahedralNormal{128, 128});
  CHECK(octahedral_normal({1, 0, 0}) == OctahedralNormal{255, 128});
  CHECK(octahedral_normal({1, 1, 0}) == OctahedralNormal{192, 192});  // folding would make it 191
  CHECK(octahedral_normal({-1, -1, 0}) == OctahedralNormal{64, 64});
  CHECK(octahedral_normal({0, 0, -1}) == OctahedralNormal{255, 255});
}

TEST_CASE(
    "any two bytes decode to no normal or to a unit vector that encodes to an equivalent code") {
  for (int u = 0; u < 256; ++u)
    for (int v = 0; v < 256; ++v) {
      const OctahedralNormal encoded{static_cast<uint8_t>(u), static_cast<uint8_t>(v)};
      const UnitNormal n = unit_normal(encoded);
      REQUIRE((u != 0) == (n != UnitNormal{0, 0, 0}));
      if (u == 0 || v == 0) continue;
      REQUIRE(length(direction_of(n)) == doctest::Approx(16384).epsilon(1e-4));
      const OctahedralNormal again = octahedral_normal({n.x, n.y, n.z});
      // On the rim and its folds, two codes represent one direction.
      if (again != encoded) REQUIRE(unit_normal(again) == n);
    }
}

TEST_CASE("normals transform with the inverse of the spacing, mirrored axes included") {
  Chance chance(4);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    int32_t spacing[3];
    for (int32_t& s : spacing) {  // ratios up to 1000
      s = static_cast<int32_t>(1 + chance.next() % 1000000) * 1000 + 1000000;
      if (chance.below(2) == 0) s = -s;
    }
    const LongVector v = vector_of(chance, 21);
    if (is_zero(v)) continue;
    const Direction3 expected = {static_cast<double>(v.x) / spacing[0],
                                 static_cast<double>(v.y) / spacing[1],
                                 static_cast<double>(v.z) / spacing[2]};
    const UnitNormal n = unit_normal(weighted(v, axis_weights(spacing)));
    worst = std::max(worst, degrees_between(direction_of(n), expected));
  }
  CHECK(worst < 0.006);
}

TEST_CASE("extreme spacings and vectors do not overflow") {
  const int32_t most = INT32_MAX, least = INT32_MIN;
  const AxisWeights even = axis_weights({most, most, most});
  CHECK(even.x == even.y);
  CHECK(even.y == even.z);
  CHECK(even.x > 0);
  const AxisWeights steep = axis_weights({1, least, most});
  CHECK(steep.x > 0);
  CHECK(steep.y == -1);  // rounding would make it 0
  CHECK(unit_normal(weighted({0, 1, 0}, steep)) == UnitNormal{0, -16384, 0});
  CHECK(unit_normal(weighted({1, 1, 1}, steep)) == UnitNormal{16384, 0, 0});
  const AxisWeights mirrored = axis_weights({-5, 5, 5});
  CHECK(unit_normal(weighted({INT64_MAX, 0, 0}, mirrored)) == UnitNormal{-16384, 0, 0});
  CHECK(unit_normal(weighted({INT64_MIN, 0, 0}, mirrored)) == UnitNormal{16384, 0, 0});
}

TEST_CASE("axis weights are rounded to the nearest integer") {
  const AxisWeights halves = axis_weights({1, 65537, 65534});  // quarters of the products
  CHECK(halves.y == 65534 / 4 + 1);
  CHECK(halves.z == 65537 / 4);
  CHECK(axis_weights({1, 65537, 65535}).x == 1 << 30);  // the product is 2^32 - 1
}

TEST_CASE("a vector below 2^31 is weighted exactly") {
  const auto check = [](const LongVector& v, const AxisWeights& weights) {
    const LongVector product = weighted(v, weights);
    CHECK(product.x == v.x * weights.x);
    CHECK(product.y == v.y * weights.y);
    CHECK(product.z == v.z * weights.z);
  };
  check({3, -4, 5}, {});
  check({INT32_MAX, 1, -INT32_MAX}, {INT32_MAX, -INT32_MAX, INT32_MAX});
}

TEST_CASE("a spacing with a zero component counts as cubic voxels") {
  const int32_t spacings[][3] = {{0, 7, 9}, {7, 0, 9}, {7, 9, 0}};
  for (const auto& spacing : spacings)
    CHECK(unit_normal(weighted({3, 4, 5}, axis_weights(spacing))) == unit_normal({3, 4, 5}));
}

TEST_CASE("vectors add by component, and normals differ if any component differs") {
  const LongVector sum = LongVector{1, 2, 3} + LongVector{10, 200, 3000};
  CHECK(sum.x == 11);
  CHECK(sum.y == 202);
  CHECK(sum.z == 3003);
  const UnitNormal unit{1, 2, 3};
  CHECK(unit == UnitNormal{1, 2, 3});
  for (const UnitNormal other : {UnitNormal{0, 2, 3}, UnitNormal{1, 0, 3}, UnitNormal{1, 2, 0}})
    CHECK(unit != other);
  const OctahedralNormal octahedral{1, 2};
  CHECK(octahedral == OctahedralNormal{1, 2});
  CHECK(!(octahedral != OctahedralNormal{1, 2}));
  for (const OctahedralNormal other : {OctahedralNormal{0, 2}, OctahedralNormal{1, 0}})
    CHECK(!(octahedral == other));
}

TEST_CASE("the area vectors of a closed surface add up to zero") {
  const reference::BitVolume volume = reference::ball({14, 13, 12}, {13, 12, 11}, 30);
  LongVector sum{0, 0, 0};
  uint64_t lengths = 0;
  const reference::Collector collector = reference::scan<uint32_t>(volume);
  for (const reference::Region& region : collector.regions())
    for (const reference::Ring& ring : region.rings) {
      const int64_t doubled =
          twice_area(region.incidence, ring.data(), static_cast<uint32_t>(ring.size()));
      const LongVector area = area_vector(region.incidence, doubled);
      sum = sum + area;
      lengths += static_cast<uint64_t>(length(direction_of(area)));
    }
  CHECK(lengths > 1000);
  CHECK(is_zero(sum));
}

TEST_CASE("area vectors are as long as the area for every incidence") {
  // A square of side 2, a rectangle of 2 by 2 sqrt(2), and a triangle of side sqrt(2).
  const LongVector axis = area_vector(incidence_of({0, 0, 1}), 2 * 4);
  const LongVector diagonal = area_vector(incidence_of({1, 1, 0}), 2 * 8);
  const LongVector corner = area_vector(incidence_of({1, 1, 1}), 3);
  CHECK(length(direction_of(axis)) == doctest::Approx(12 * 4));
  CHECK(length(direction_of(diagonal)) == doctest::Approx(12 * 4 * std::sqrt(2.0)));
  CHECK(length(direction_of(corner)) == doctest::Approx(12 * std::sqrt(3.0) / 2));
}
