#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "byte_source.hpp"

namespace discmc::command {
namespace {

constexpr std::size_t buffered = 4096;  // number of samples

class HalfSamples final : public PartwiseSource {
 public:
  HalfSamples(std::unique_ptr<ByteSource> in, bool is_big_endian)
      : in_(std::move(in)), is_big_endian_(is_big_endian) {}

  std::uint64_t max_left() const override {
    const std::uint64_t halves = in_->max_left();
    if (halves >= unbounded / 2 - sizeof floats_) return unbounded;
    return halves / 2 * 4 + left_in_part();
  }
  void check_end() override { in_->check_end(); }
  std::string damage() const override { return in_->damage(); }

 private:
  bool next_part() override {
    std::array<unsigned char, 2 * buffered> halves;
    const std::size_t count = in_->read(halves.data(), halves.size()) / 2;
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned high = halves[2 * i + (is_big_endian_ ? 0 : 1)];
      const unsigned low = halves[2 * i + (is_big_endian_ ? 1 : 0)];
      floats_[i] = float_of_half(static_cast<std::uint16_t>(high << 8 | low));
    }
    set_part(floats_.data(), count * sizeof(float));
    return count > 0;
  }

  std::unique_ptr<ByteSource> in_;
  bool is_big_endian_;
  std::array<float, buffered> floats_{};
};

}  // namespace

float float_of_half(std::uint16_t half) {
  const int exponent = half >> 10 & 0x1f;
  const int fraction = half & 0x3ff;
  float size = std::ldexp(static_cast<float>(fraction + 0x400), exponent - 25);
  if (exponent == 0) size = std::ldexp(static_cast<float>(fraction), -24);
  if (exponent == 0x1f)
    size = fraction == 0 ? std::numeric_limits<float>::infinity()
                         : std::numeric_limits<float>::quiet_NaN();
  return (half & 0x8000) != 0 ? -size : size;
}

std::unique_ptr<ByteSource> floats_of_halves(std::unique_ptr<ByteSource> in, bool is_big_endian) {
  return std::make_unique<HalfSamples>(std::move(in), is_big_endian);
}

}  // namespace discmc::command
