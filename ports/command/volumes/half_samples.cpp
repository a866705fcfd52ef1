#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "byte_source.hpp"
#include "half_float.hpp"

namespace discmc::command {
namespace {

constexpr std::size_t buffered = 4096;  // samples

class HalfSamples final : public ByteSource {
 public:
  HalfSamples(std::unique_ptr<ByteSource> in, bool is_big_endian)
      : in_(std::move(in)), is_big_endian_(is_big_endian) {}

  std::size_t read(void* bytes, std::size_t count) override {
    std::size_t done = 0;
    while (done < count && (begin_ < end_ || refill())) {
      const std::size_t part = std::min(count - done, end_ - begin_);
      std::memcpy(static_cast<char*>(bytes) + done,
                  reinterpret_cast<const char*>(floats_.data()) + begin_, part);
      begin_ += part;
      done += part;
    }
    return done;
  }

  std::uint64_t max_left() const override {
    const std::uint64_t halves = in_->max_left();
    if (halves >= unbounded / 2 - sizeof floats_) return unbounded;
    return halves / 2 * 4 + (end_ - begin_);
  }
  void check_end() override { in_->check_end(); }
  std::string damage() const override { return in_->damage(); }

 private:
  bool refill() {
    std::array<unsigned char, 2 * buffered> halves;
    const std::size_t count = in_->read(halves.data(), halves.size()) / 2;
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned high = halves[2 * i + (is_big_endian_ ? 0 : 1)];
      const unsigned low = halves[2 * i + (is_big_endian_ ? 1 : 0)];
      floats_[i] = float_of_half(static_cast<std::uint16_t>(high << 8 | low));
    }
    begin_ = 0;
    end_ = count * sizeof(float);
    return count > 0;
  }

  std::unique_ptr<ByteSource> in_;
  bool is_big_endian_;
  std::array<float, buffered> floats_{};
  std::size_t begin_ = 0;  // of their bytes
  std::size_t end_ = 0;
};

}  // namespace

std::unique_ptr<ByteSource> floats_of_halves(std::unique_ptr<ByteSource> in, bool is_big_endian) {
  return std::make_unique<HalfSamples>(std::move(in), is_big_endian);
}

}  // namespace discmc::command
