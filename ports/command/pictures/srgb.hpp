// A colour as screens and files have it.
#ifndef DISCMC_COMMAND_PICTURES_SRGB_HPP
#define DISCMC_COMMAND_PICTURES_SRGB_HPP

#include <array>
#include <cstdint>

namespace discmc::command {

/// Red, green and blue of the colour space sRGB.
using Srgb = std::array<std::uint8_t, 3>;

}  // namespace discmc::command

#endif
