// Palettes of pictures: samples are numbers of colours.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_PALETTE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_PALETTE_HPP

#include <cstddef>
#include <vector>

#include "pictures/srgb.hpp"

namespace discmc::command {

using Palette = std::vector<Srgb>;

/// Whether its colours are grey values: samples then become those, not their numbers.
bool is_grey(const Palette& palette);

/// Replaces numbers of greys by the greys. Limit: is_grey(palette). Numbers beyond it stay.
void resolve_greys(const Palette& palette, unsigned char* samples, std::size_t count);

}  // namespace discmc::command

#endif
