#include <discmc/compiler.hpp>
#include <discmc/host/numbered_passes.hpp>

namespace discmc::trace {

namespace {

uint64_t bits_of(const Pass& pass) {
  uint64_t bits;
  static_assert(sizeof bits == sizeof pass);
  copy_bytes(&bits, &pass, sizeof bits);
  return bits;
}

}  // namespace

NumberedPasses::Numbers NumberedPasses::of(const Pass& pass, int axis) {
  // No pass is found on two axes.
  const uint64_t bits = bits_of(pass);
  // Multiplication spreads neighbouring keys: see Holes.
  uint64_t place = bits * 0x9E3779B97F4A7C15U >> (64 - place_bits);
  while (known_[place].pass != bits && known_[place].numbers.count != 0)
    place = (place + 1) % (1U << place_bits);
  Known& known = known_[place];
  if (known.numbers.count == 0) {
    CornerPass made[CornerPass::max_of_pass];
    const uint32_t count = corner_passes(pass, axis, made);
    known.pass = bits;
    known.numbers = {static_cast<uint16_t>(count_), static_cast<uint16_t>(count)};
    for (uint32_t i = 0; i < count; ++i, ++count_) {
      numbered_[count_] = made[i];
      numbered_[count_].corner -= count_;
    }
  }
  return known.numbers;
}

}  // namespace discmc::trace
