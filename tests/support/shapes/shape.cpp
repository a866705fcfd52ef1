#include "shape.hpp"

#include <algorithm>

#include "bars.hpp"
#include "combs.hpp"
#include "fractals.hpp"
#include "plates.hpp"
#include "saws.hpp"
#include "shells.hpp"
#include "stripes.hpp"
#include "tents.hpp"
#include "tilings.hpp"

namespace discmc::shapes {

namespace {

using reference::Size;

On draw_bars(const Below& below) {
  const bool is_dense = below(2) == 0;
  const uint32_t period = is_dense ? 2 : 3 + below(4);
  return Bars{period, 1 + below(period - 1), below(period), 1 + below(3)};
}

On draw_tiling(const Below& below) {
  const uint32_t side = 1 + below(8) / 6;
  const auto configuration = static_cast<uint8_t>(below(256));
  return Tiling{configuration, below(2 * side), below(2 * side), below(2 * side), side};
}

On draw_tents(const Below& below) {
  const uint32_t period = 4U << below(3);
  return Tents{8 + below(150), period, 1 + below(period - 1), 2 + below(4), below(2) == 1};
}

On draw_saw(const Below& below) {
  const uint32_t pitch = 3 + below(8);
  return Saw{pitch, 1 + below(pitch - 1), 1 + below(pitch), 1 + below(4)};
}

On draw_comb(const Size& size, const Below& below) {
  const uint32_t pitch = 2 + below(6);
  const uint32_t rows = std::max({size.width, size.height, size.depth});
  return Comb{pitch, 1 + below(pitch - 1), rows - std::min(rows, 1 + below(3)), below(3), below(3)};
}

On draw_shells(const Below& below) {
  const auto norm = static_cast<Shells::Norm>(below(3));
  const uint32_t cell = 4 + below(120);
  const uint32_t period = 2 + below(norm == Shells::Norm::ball ? 200 : 7);
  return Shells{norm, cell, period, 1 + below(period - 1)};
}

On draw_plates(const Below& below) {
  const uint32_t spacing = 2 + below(4);
  return Plates{4 + below(30), 1 + below(3), spacing, 1 + below(spacing - 1), below(3)};
}

On draw_stripes(const Below& below) {
  const auto slope = [&] { return static_cast<int32_t>(below(9)) - 4; };
  const int32_t x = slope(), y = slope(), z = slope();
  const uint32_t period = 2 + below(40);
  return Stripes{x, y, z, period, 1 + below(period - 1)};
}

On draw_upright(Kind kind, const Size& size, const Below& below) {
  switch (kind) {
    case Kind::bars:
      return draw_bars(below);
    case Kind::tiling:
      return draw_tiling(below);
    case Kind::tents:
      return draw_tents(below);
    case Kind::saw:
      return draw_saw(below);
    case Kind::comb:
      return draw_comb(size, below);
    case Kind::shells:
      return draw_shells(below);
    case Kind::plates:
      return draw_plates(below);
    case Kind::stripes:
      return draw_stripes(below);
    case Kind::fractal:
      return Fractal{static_cast<Fractal::Kind>(below(3))};
  }
  return {};
}

On turned(On on, uint32_t turn) {
  switch (turn) {
    case 1:
      return [on = std::move(on)](uint32_t x, uint32_t y, uint32_t z) { return on(y, x, z); };
    case 2:
      return [on = std::move(on)](uint32_t x, uint32_t y, uint32_t z) { return on(z, y, x); };
    case 3:
      return [on = std::move(on)](uint32_t x, uint32_t y, uint32_t z) { return on(x, z, y); };
    case 4:
      return [on = std::move(on)](uint32_t x, uint32_t y, uint32_t z) { return on(y, z, x); };
    case 5:
      return [on = std::move(on)](uint32_t x, uint32_t y, uint32_t z) { return on(z, x, y); };
    default:
      return on;
  }
}

// Whether a voxel, one in some, is noise, by the finalizer of MurmurHash3 (Appleby).
bool is_noise(uint32_t x, uint32_t y, uint32_t z, uint32_t seed, uint32_t one_in) {
  uint32_t mixed = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ z * 0xC2B2AE3DU ^ seed * 0x27D4EB2FU;
  mixed = (mixed ^ mixed >> 16) * 0x85EBCA6BU;
  mixed = (mixed ^ mixed >> 13) * 0xC2B2AE35U;
  return (mixed ^ mixed >> 16) % one_in == 0;
}

}  // namespace

const char* name_of(Kind kind) {
  constexpr const char* names[kinds] = {"bars",   "tiling", "tents",   "saw",    "comb",
                                        "shells", "plates", "stripes", "fractal"};
  return names[static_cast<uint32_t>(kind)];
}

On draw_shape(Kind kind, const Size& size, const Below& below) {
  const uint32_t turn = below(16);  // most shapes stay unchanged
  const uint32_t rough = below(8);
  const uint32_t seed = below(256);
  On on = turned(draw_upright(kind, size, below), turn);
  if (rough == 0)
    return [on = std::move(on)](uint32_t x, uint32_t y, uint32_t z) { return !on(x, y, z); };
  if (rough > 2) return on;
  const uint32_t one_in = rough == 1 ? 1000 : 40;
  return [on = std::move(on), seed, one_in](uint32_t x, uint32_t y, uint32_t z) {
    return on(x, y, z) != is_noise(x, y, z, seed, one_in);
  };
}

}  // namespace discmc::shapes
