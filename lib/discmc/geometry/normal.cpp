#include <discmc/base/compiler.hpp>
#include <discmc/normal.hpp>

namespace discmc {

namespace {

constexpr uint64_t magnitude(int64_t value) {
  return value < 0 ? 0 - static_cast<uint64_t>(value) : static_cast<uint64_t>(value);
}

// Returns the number of bits that the largest component needs.
int bits_of(const LongVector& v) {
  const uint64_t together = magnitude(v.x) | magnitude(v.y) | magnitude(v.z);
  return static_cast<int>(bit_width(together));
}

// Rounds a half away from zero, so that opposite vectors stay opposite.
int64_t shifted_right(int64_t value, int bits) {
  const uint64_t size = (magnitude(value) + (uint64_t{1} << bits >> 1)) >> bits;
  return value < 0 ? -static_cast<int64_t>(size) : static_cast<int64_t>(size);
}

int64_t shifted(int64_t value, int left) {
  return left >= 0 ? value * (int64_t{1} << left) : shifted_right(value, -left);
}

// Scales the vector until its largest component has this many bits; rounding may add one.
LongVector scaled(const LongVector& v, int bits) {
  const int left = bits - bits_of(v);
  return {shifted(v.x, left), shifted(v.y, left), shifted(v.z, left)};
}

// Scales the vector for arithmetic in 32 bits: the largest component is 2^14 to 2^15.
struct ShortVector {
  int32_t x, y, z;
};

ShortVector shortened(const LongVector& v) {
  const LongVector s = scaled(v, 15);
  return {static_cast<int32_t>(s.x), static_cast<int32_t>(s.y), static_cast<int32_t>(s.z)};
}

uint32_t size_of(int32_t value) {
  return static_cast<uint32_t>(value < 0 ? -value : value);
}

// Computes bit by bit the largest number whose square is at most `value`.
uint32_t square_root(uint32_t value) {
  uint32_t root = 0;
  for (uint32_t bit = 1U << 15; bit > 0; bit >>= 1) {
    const uint32_t larger = root | bit;
    if (larger * larger <= value) root = larger;
  }
  return root;
}

// Returns value * scale / whole, rounded. Limit: |value| <= whole, |value| * scale < 2^31.
int32_t share(int32_t value, uint32_t scale, uint32_t whole) {
  const uint32_t size = (size_of(value) * scale + whole / 2) / whole;
  return value < 0 ? -static_cast<int32_t>(size) : static_cast<int32_t>(size);
}

// Folds a point of the lower half of the octahedron outwards, and back: the function is its own
// inverse.
void fold(int32_t& u, int32_t& v) {
  const int32_t folded_u = 127 - static_cast<int32_t>(size_of(v));
  const int32_t folded_v = 127 - static_cast<int32_t>(size_of(u));
  u = u < 0 ? -folded_u : folded_u;
  v = v < 0 ? -folded_v : folded_v;
}

}  // namespace

AxisWeights axis_weights(const int32_t (&spacing)[3]) {
  if (spacing[0] == 0 || spacing[1] == 0 || spacing[2] == 0) return {};
  const auto product = [&](int a, int b) {
    return static_cast<int64_t>(magnitude(spacing[a]) * magnitude(spacing[b]));
  };
  const LongVector products = {product(1, 2), product(2, 0), product(0, 1)};
  const LongVector weight = scaled(products, 30);
  // Never returns 0, which would lose a normal along the axis.
  const auto signed_as = [](int32_t value, int64_t size) {
    const int64_t nonzero_size = size > 0 ? size : 1;
    return static_cast<int32_t>(value < 0 ? -nonzero_size : nonzero_size);
  };
  return {signed_as(spacing[0], weight.x), signed_as(spacing[1], weight.y),
          signed_as(spacing[2], weight.z)};
}

LongVector weighted(const LongVector& vector, const AxisWeights& weights) {
  const LongVector v = bits_of(vector) > 31 ? scaled(vector, 31) : vector;
  return {v.x * weights.x, v.y * weights.y, v.z * weights.z};
}

UnitNormal unit_normal(const LongVector& direction) {
  const ShortVector v = shortened(direction);
  const uint32_t length =
      square_root(static_cast<uint32_t>(v.x * v.x) + static_cast<uint32_t>(v.y * v.y) +
                  static_cast<uint32_t>(v.z * v.z));
  if (length == 0) return {0, 0, 0};
  const auto component = [length](int32_t value) {
    return static_cast<int16_t>(share(value, UnitNormal::one, length));
  };
  return {component(v.x), component(v.y), component(v.z)};
}

OctahedralNormal octahedral_normal(const LongVector& direction) {
  const ShortVector n = shortened(direction);
  const uint32_t sum = size_of(n.x) + size_of(n.y) + size_of(n.z);
  if (sum == 0) return {0, 0};
  int32_t u = share(n.x, 127, sum);
  int32_t v = share(n.y, 127, sum);
  if (n.z < 0) fold(u, v);
  return {static_cast<uint8_t>(128 + u), static_cast<uint8_t>(128 + v)};
}

UnitNormal unit_normal(OctahedralNormal normal) {
  if (normal.is_none()) return {0, 0, 0};
  int32_t u = normal.u - 128;
  int32_t v = normal.v - 128;
  const int32_t z = 127 - static_cast<int32_t>(size_of(u) + size_of(v));
  if (z < 0) fold(u, v);
  return unit_normal(LongVector{u, v, z});
}

}  // namespace discmc
