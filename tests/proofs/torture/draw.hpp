// Makes the test case of a seed: a volume, and the ways in which it is scanned.
#pragma once

#include <string>
#include <vector>

#include "placed_volume.hpp"
#include "shapes/shape.hpp"
#include "slab_scan.hpp"

namespace discmc::torture {

struct DrawnVolume {
  PlacedVolume volume;
  std::string text;
  bool is_small;  ///< small enough for the reference
};

DrawnVolume draw_volume(const shapes::Below& below);

/// One way to scan a volume. The slabs are in the order in which a joiner receives them.
struct Arrangement {
  std::vector<SlabPlan> slabs;
  std::string text;
};

/// Slabs of this many slices, one kind of extractor, ample memory.
Arrangement in_much_memory(const PlacedVolume& volume, Scanner scanner, uint32_t slices);
/// Slabs of any thickness, any extractors, any memory.
Arrangement draw_arrangement(const PlacedVolume& volume, const shapes::Below& below);

}  // namespace discmc::torture
