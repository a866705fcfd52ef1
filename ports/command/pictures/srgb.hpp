// Colours of screens and files.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace discmc::command {

/// Red, green and blue of the colour space sRGB.
using Srgb = std::array<std::uint8_t, 3>;

/// Convert between a share of linear light and the share of 255 that encodes it (IEC 61966-2-1).
template <class Real>
Real encoded_light(Real light) {
  return light <= Real(0.0031308) ? Real(12.92) * light
                                  : Real(1.055) * std::pow(light, 1 / Real(2.4)) - Real(0.055);
}
template <class Real>
Real decoded_light(Real share) {
  return share <= Real(0.04045) ? share / Real(12.92)
                                : std::pow((share + Real(0.055)) / Real(1.055), Real(2.4));
}

/// Converts a share to a byte, clamped to the range 0 to 255.
inline std::uint8_t byte_of_share(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

/// Returns the colour of a label. Numbers 1 to 7 have the colours that people with any colour
/// vision can distinguish (M. Okabe, K. Ito, Color Universal Design, 2008); 8 to 14 are lighter, 15
/// to 21 darker. Number n + 21 has the colour of n. Limit: finite.
inline Srgb label_colour(double number) {
  constexpr Srgb colours[] = {{230, 159, 0}, {86, 180, 233}, {0, 158, 115},  {240, 228, 66},
                              {0, 114, 178}, {213, 94, 0},   {204, 121, 167}};
  constexpr int count = 7;
  const double turn = std::fmod(number - 1, 3 * count);
  const int place = static_cast<int>(turn < 0 ? turn + 3 * count : turn);
  Srgb colour = colours[place % count];
  for (std::uint8_t& part : colour) {
    if (place / count == 1) part = static_cast<std::uint8_t>(part + (255 - part) / 2);
    if (place / count == 2) part = static_cast<std::uint8_t>(part / 2);
  }
  return colour;
}

}  // namespace discmc::command
