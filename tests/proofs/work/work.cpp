// Counts the maximum work of a row, and compares it with the bound of lib/DESIGN.md ("Work").
//
// The compiler adds a call of the counter below to every basic block of the library. So the counts
// are equal in every run, and the sources need no change.

#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>

#include "proofs/work/counted_scan.hpp"
#include "proofs/work/counted_slices.hpp"

using namespace discmc;
using namespace discmc::reference;
using namespace discmc::work;

uint64_t discmc::work::blocks = 0;

// The compiler's instrumentation requires this name.
extern "C" void __sanitizer_cov_trace_pc();  // NOLINT(bugprone-reserved-identifier)
void __sanitizer_cov_trace_pc() {            // NOLINT(bugprone-reserved-identifier)
  ++blocks;
}

namespace {

constexpr const char* usage =
    R"(usage: work [STEPS]

Counts the basic blocks that the library executes for every row of hostile volumes, in ample and in
hardly any memory, and compares them with the bound of lib/DESIGN.md, "Work". Then changes small
volumes voxel by voxel in search of a row beyond it, STEPS times (default 10000).

Exit status: 0, or 1 if a row is beyond the bound, or 2 for an argument that is not understood.
)";

struct Hostile {
  const char* name;
  BitVolume volume;
};

// A wall on teeth in the first slices. The slice above joins many chains one by one.
BitVolume wall_on_teeth(Size size) {
  return volume_of(size, [](uint32_t, uint32_t y, uint32_t z) { return z >= 2 || y % 2 == 0; });
}

// Every other voxel of a row, with nothing before: all coded runs end early.
BitVolume teeth_on_nothing(Size size) {
  BitVolume volume(size);
  const size_t first = volume.index(0, size.height - 1, size.depth - 1);
  for (size_t x = 1; x < size.width; x += 2) volume.on[first + x] = 1;
  return volume;
}

std::vector<Hostile> hostile_volumes() {
  const Size size{40, 40, 8};
  return {{"empty", BitVolume(size)},
          {"ball", ball({40, 40, 40}, {39, 39, 39}, 360)},
          {"checkerboard", checkerboard(size)},
          {"columns", columns(size)},
          {"tiling 61", tiling_61(size)},
          {"random", random(size, 128, 1)},
          {"random, sparse", random(size, 25, 2)},
          {"random, dense", random(size, 230, 3)},
          {"comb", comb(size)},
          {"wall on teeth", wall_on_teeth({2, 16000, 5})},
          {"spiral", spiral({90, 90, 3})},
          {"one wall, 66,000 slices", box({2, 2, 66000}, {0, 0, 0}, {1, 1, 65999})},
          {"widest rows, checkerboard", checkerboard({Limits::max_extent, 2, 2})},
          {"widest rows, teeth", teeth_on_nothing({Limits::max_extent, 2, 3})},
          {"widest rows, random", random({Limits::max_extent, 2, 2}, 128, 4)}};
}

// Memory: more than any volume needs; so little that fragments are measured; less; the minimum.
std::vector<Room> rooms(Capacities ample) {
  return {{"ample", ample},
          {"1,000 slots", {1000, 60}},
          {"60 slots", {60, 4}},
          {"least", minimum_capacities()}};
}

bool check_hostile_volumes() {
  std::printf("%-26s %-7s %-13s %12s %10s %9s %6s\n", "volume", "border", "memory", "most a push",
              "a vertex", "of bound", "fragments");
  bool holds = true;
  for (const Hostile& hostile : hostile_volumes())
    for (const Border border : {Border::closed, Border::open}) {
      for (const Room& room : rooms({4000000, 100000})) {
        const Work work = CountedScan(hostile.volume, border, room).run();
        const uint64_t a_vertex = work.blocks / std::max<uint64_t>(work.vertices, 1);
        std::printf("%-26s %-7s %-13s %12" PRIu64 " %10" PRIu64 " %8.1f%% %6" PRIu64 "\n",
                    hostile.name, border == Border::closed ? "closed" : "open", room.name,
                    work.max_blocks, work.vertices > 0 ? a_vertex : 0, 100 * work.max_of_bound,
                    work.fragments);
        holds = holds && work.max_of_bound <= 1;
      }
    }
  return holds;
}

bool check_slices() {
  std::printf("\n%-26s %-12s %8s %6s %12s %9s\n", "rows of slices", "key slices", "surfaces",
              "levels", "most a push", "of bound");
  bool holds = true;
  for (const Hostile& hostile : hostile_volumes())
    for (const uint32_t interval : {0u, 1u})
      for (const uint8_t surfaces : {uint8_t{1}, uint8_t{4}})
        for (const uint8_t levels : {uint8_t{0}, uint8_t{4}}) {
          const auto encode = levels == 0 ? encode_slices<SliceEncoder>
                                          : encode_slices<FractionSliceEncoder<uint8_t>>;
          const SliceWork work = encode(hostile.volume, interval, surfaces, levels);
          std::printf("%-26s %-12" PRIu32 " %8d %6d %12" PRIu64 " %8.1f%%\n", hostile.name,
                      interval, surfaces, levels, work.max_blocks, 100 * work.max_of_bound);
          holds = holds && work.max_of_bound <= 1;
        }
  return holds;
}

// Flips some voxels, or copies a row or slice over another.
void change(BitVolume& volume, std::mt19937& chance) {
  const auto below = [&](size_t limit) { return chance() % limit; };
  const size_t stretch = below(8) == 0 ? volume.width * (below(2) == 0 ? 1 : volume.height) : 0;
  if (stretch > 0) {
    const size_t count = volume.voxels() / stretch;
    std::copy_n(volume.on.begin() + static_cast<std::ptrdiff_t>(below(count) * stretch), stretch,
                volume.on.begin() + static_cast<std::ptrdiff_t>(below(count) * stretch));
  }
  for (size_t flips = 1 + below(4); flips > 0; --flips) volume.on[below(volume.voxels())] ^= 1;
}

// Starts with noise and keeps the changes that bring a row nearer to its bound.
double climb(Border border, const Room& room, Size size, uint64_t steps, uint32_t seed) {
  std::mt19937 chance(seed);
  BitVolume best = random(size, 128, seed);
  double max_share = CountedScan(best, border, room).run().max_at_work;
  for (uint64_t step = 0; step < steps; ++step) {
    BitVolume changed = best;
    change(changed, chance);
    const double share = CountedScan(changed, border, room).run().max_at_work;
    if (share < max_share) continue;
    max_share = share;
    best = std::move(changed);
  }
  return max_share;
}

bool search_for_worse(uint64_t steps) {
  const Size size{9, 4, 4};
  const std::vector<Room> small_rooms = rooms({10000, 1000});
  bool holds = true;
  for (const Border border : {Border::closed, Border::open}) {
    for (const Room& room : small_rooms) {
      const double max_share = climb(border, room, size, steps / (2 * small_rooms.size()), 1);
      std::printf("search: %-7s %-13s %5.1f%% of the bound\n",
                  border == Border::closed ? "closed" : "open", room.name, 100 * max_share);
      std::fflush(stdout);
      holds = holds && max_share <= 1;
    }
  }
  return holds;
}

}  // namespace

int main(int count, char** arguments) {
  uint64_t steps = 10000;
  if (count == 2 && std::strcmp(arguments[1], "--help") == 0) {
    std::fputs(usage, stdout);
    return 0;
  }
  if (count == 2) {
    const char* const end = arguments[1] + std::strlen(arguments[1]);
    const auto read = std::from_chars(arguments[1], end, steps);
    if (read.ec != std::errc() || read.ptr != end) count = 0;
  }
  if (count < 1 || count > 2) {
    std::fputs(usage, stderr);
    return 2;
  }
  const bool volumes_hold = check_hostile_volumes();
  const bool slices_hold = check_slices();
  const bool search_holds = search_for_worse(steps);
  if (volumes_hold && slices_hold && search_holds) return 0;
  std::fputs("work: a row beyond the bound\n", stderr);
  return 1;
}
