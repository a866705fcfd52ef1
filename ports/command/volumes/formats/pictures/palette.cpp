#include "palette.hpp"

#include <algorithm>

namespace discmc::command {

bool is_grey(const Palette& palette) {
  return !palette.empty() && std::all_of(palette.begin(), palette.end(), [](const Srgb& colour) {
    return colour[0] == colour[1] && colour[1] == colour[2];
  });
}

void resolve_greys(const Palette& palette, unsigned char* samples, std::size_t count) {
  std::for_each(samples, samples + count, [&palette](unsigned char& sample) {
    if (sample < palette.size()) sample = palette[sample][0];
  });
}

}  // namespace discmc::command
