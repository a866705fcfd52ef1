// The scan whose instructions are counted: a ball with some 23 voxels for every active cell, as a
// CT scan has. Prints the number of active cells.
#include <discmc/extractor.hpp>

#include <cstdint>
#include <cstdio>
#include <memory>

#include "oracle/volume.hpp"

using namespace discmc;

namespace {

constexpr uint32_t extent = 96;

Answer take_event(void*, const Event&) {
  return Answer::taken;
}

uint64_t active_cells(const reference::BitVolume& volume) {
  uint64_t active = 0;
  reference::for_each_cell(volume, true, [&](const Vertex&, Configuration configuration) {
    if (configuration != 0 && configuration != 255) ++active;
  });
  return active;
}

}  // namespace

// Instructions are counted while this is executed: the name must stay and nothing may be inlined.
extern "C" [[gnu::noinline]] bool counted_scan(Extractor32& extractor,
                                               const reference::BitVolume& volume) {
  const auto voxels = static_cast<uint32_t>(volume.on.size());
  return extractor.push(volume.on.data(), voxels).status == Status::ok &&
         extractor.finish() == Status::ok;
}

int main() {
  const reference::BitVolume volume =
      reference::ball({extent, extent, extent}, {extent - 1, extent - 1, extent - 1}, 45 * 45);
  const Limits limits{extent, extent};
  const size_t bytes = worst_case_bytes<uint32_t>(limits);
  const std::unique_ptr<uint8_t[]> memory(new uint8_t[bytes]);
  Extractor32 extractor;
  if (extractor.start(limits, 1, {memory.get(), bytes}, {nullptr, take_event}) != Status::ok ||
      !counted_scan(extractor, volume))
    return 1;
  std::printf("%llu\n", static_cast<unsigned long long>(active_cells(volume)));
  return 0;
}
