#include "draw.hpp"

#include <algorithm>
#include <utility>

#include "shapes/sizes.hpp"

namespace discmc::torture {

namespace {

using shapes::Below;

// Enough for fragments in nearly all volumes. Limit: 64 MiB.
Capacities ample_capacities(const Limits& limits, uint32_t slices) {
  constexpr uint32_t slots_per_voxel = 64, most = 1U << 22;
  const uint32_t voxels = limits.width * limits.height * (slices + 2);
  const uint32_t slots = std::min((1U << 15) + slots_per_voxel * voxels, most);
  return {slots, slots};
}

// Six sizes, from the minimum to ample.
Capacities draw_memory(uint32_t memory, const Capacities& most, const Below& below) {
  constexpr uint32_t least = minimum_capacities().slots;
  switch (memory) {
    case 0:
      return minimum_capacities();
    case 1:
      return {least + below(200), below(16)};
    case 2:
      return {1000 + 32 * below(256), 16 * below(64)};
    case 3:
      return {10000 + 256 * below(64), below(200)};
    case 4:
      return {30000 + 16 * below(256), 100 + below(200)};
    default:
      return most;
  }
}

Capacities within_narrow(const Capacities& capacities) {
  return {std::min(capacities.slots, reference::ample.slots),
          std::min(capacities.holes, reference::ample.holes)};
}

// Offsets near which a coordinate, the place of a corner or a count needs one bit more.
uint32_t draw_slices_below(uint32_t depth, const Below& below) {
  const uint32_t near = below(2 * std::min(depth, 20U) + 2);
  switch (below(8)) {
    case 0:
      return 16380 + 8 - near;
    case 1:
      return 32760 + 8 - near;
    case 2:
      return (1U << 20) + 8 - near;
    case 3:
      return Limits::max_slices - depth - 3 - below(4);
    default:
      return 0;
  }
}

// One kind of extractor for all slabs, or any kind for each. Hosts are most frequent, because they
// have the most code.
Scanner draw_scanner(uint32_t choice, const Below& below) {
  constexpr Scanner of_all[] = {Scanner::narrow, Scanner::wide, Scanner::host, Scanner::host};
  return choice < 4 ? of_all[choice] : static_cast<Scanner>(below(3));
}

// Returns the ends of slabs, ascending. thickness(rest) returns the number of slices of the next
// slab.
template <class Thickness>
std::vector<uint32_t> ends_of(const PlacedVolume& volume, Thickness thickness) {
  constexpr uint32_t max_slabs = 40;
  std::vector<uint32_t> ends;
  for (uint32_t at = volume.first_own(); at < volume.size.depth;) {
    const uint32_t rest = volume.size.depth - at;
    const uint32_t slices = ends.size() + 1 == max_slabs ? rest : thickness(rest);
    ends.push_back(at += std::min(slices, rest));
  }
  return ends;
}

std::vector<uint32_t> draw_ends(const PlacedVolume& volume, const Below& below) {
  const uint32_t fixed = below(6);  // 0: any
  return ends_of(volume, [&](uint32_t rest) {
    return fixed == 0 ? 1 + below(12) : fixed == 5 ? 1 + rest / 2 : fixed;
  });
}

std::string text_of(const SlabPlan& slab) {
  constexpr const char* names[] = {"16-bit", "32-bit", "host"};
  return "[" + std::to_string(slab.first) + ", " + std::to_string(slab.end) + ") " +
         names[static_cast<uint32_t>(slab.scanner)] + " " + std::to_string(slab.capacities.slots) +
         " slots " + std::to_string(slab.capacities.holes) + " holes" +
         (slab.refusals > 0 ? " refusals" : "") + (slab.checkpoints > 0 ? " checkpoints" : "");
}

void describe(Arrangement& arrangement) {
  for (const SlabPlan& slab : arrangement.slabs)
    arrangement.text += (arrangement.text.empty() ? "" : "; ") + text_of(slab);
}

}  // namespace

DrawnVolume draw_volume(const Below& below) {
  const uint32_t form = below(16);
  const bool is_small = form < 5;
  const reference::Size size = is_small    ? shapes::draw_small_size(below)
                               : form < 15 ? shapes::draw_wide_size(below, 1000U << below(8))
                                           : shapes::draw_long_size(below);
  const auto kind = static_cast<shapes::Kind>(below(shapes::kinds));
  const Border border = below(3) == 0 ? Border::open : Border::closed;
  PlacedVolume volume{shapes::draw_shape(kind, size, below), size, border,
                      is_small ? 0 : draw_slices_below(size.depth, below)};
  if (volume.below > 0) volume.size.depth += 2;
  std::string text = shapes::name_of(kind);
  text += " " + std::to_string(size.width) + "x" + std::to_string(size.height) + "x" +
          std::to_string(size.depth) + (border == Border::open ? " open" : " closed");
  if (volume.below > 0) text += " above " + std::to_string(volume.below) + " slices";
  return {std::move(volume), std::move(text), is_small};
}

Arrangement in_much_memory(const PlacedVolume& volume, Scanner scanner, uint32_t slices) {
  Arrangement arrangement;
  uint32_t first = volume.first_own();
  for (const uint32_t end : ends_of(volume, [slices](uint32_t) { return slices; })) {
    const Capacities most = ample_capacities(volume.limits_of_slab(first, end), end - first);
    arrangement.slabs.push_back({first, end, scanner, most, 0, 0, 0, 0});
    first = end;
  }
  describe(arrangement);
  return arrangement;
}

Arrangement draw_arrangement(const PlacedVolume& volume, const Below& below) {
  const uint32_t scanners = below(7);
  const uint32_t memories = below(10);  // 6 and 7: ample, too; 8 and 9: mixed
  const uint32_t refusals = below(3) == 0 ? below(200) : 0;
  const uint32_t checkpoints = below(4) == 0 ? 1 + below(3) : 0;
  const uint32_t chunk = below(2) == 0 ? 0 : 1 + below(256);
  Arrangement arrangement;
  uint32_t first = volume.first_own();
  for (const uint32_t end : draw_ends(volume, below)) {
    const Scanner scanner = draw_scanner(scanners, below);
    const Capacities most = ample_capacities(volume.limits_of_slab(first, end), end - first);
    Capacities memory = draw_memory(memories < 8 ? memories : below(6), most, below);
    if (scanner == Scanner::narrow) memory = within_narrow(memory);
    arrangement.slabs.push_back(
        {first, end, scanner, memory, refusals, checkpoints, chunk, below(256)});
    first = end;
  }
  // Joiners receive slabs in any order.
  for (size_t i = arrangement.slabs.size(); i > 1 && scanners % 2 == 1; --i)
    std::swap(arrangement.slabs[i - 1], arrangement.slabs[below(static_cast<uint32_t>(i))]);
  describe(arrangement);
  return arrangement;
}

}  // namespace discmc::torture
