// The scan whose instructions are counted: a ball with 23 voxels per active cell, as in a CT scan.
// Prints the number of active cells.
//
//   scan plain | host      samples by an Extractor, or rows of bits by a HostExtractor
#include "host/host_extractor.hpp"

#include <cstdint>
#include <cstdio>
#include <string_view>

#include "oracle/volume.hpp"

using namespace discmc;

namespace {

constexpr uint32_t extent = 96;

SinkResult discard_event(void*, const Event&) {
  return SinkResult::accepted;
}

constexpr uint32_t row_bytes = (extent + 7) / 8;
uint8_t bits[extent * extent * row_bytes];

void set_bits(const reference::BitVolume& volume) {
  for (uint32_t i = 0; i < volume.on.size(); ++i)
    if (volume.on[i] != 0)
      bits[i / extent * row_bytes + i % extent / 8] |= static_cast<uint8_t>(1U << i % extent % 8);
}

bool is_pushed(Extractor32& extractor, const reference::BitVolume& volume) {
  const auto voxels = static_cast<uint32_t>(volume.on.size());
  return extractor.push(volume.on.data(), voxels).status == Status::ok;
}

bool is_pushed(HostExtractor& extractor, const reference::BitVolume&) {
  for (uint32_t row = 0; row < extent * extent; ++row)
    if (extractor.push_bits(bits + row * row_bytes).status != Status::ok) return false;
  return true;
}

uint64_t active_cells(const reference::BitVolume& volume) {
  uint64_t active = 0;
  reference::for_each_cell(volume, true, [&](const Vertex&, Configuration configuration) {
    if (configuration != 0 && configuration != 255) ++active;
  });
  return active;
}

}  // namespace

// Instructions are counted within this function, so it must not be renamed or inlined.
extern "C" [[gnu::noinline]] bool counted_scan(bool (*scan)(const reference::BitVolume&),
                                               const reference::BitVolume& volume) {
  return scan(volume);
}

namespace {

template <class Scanner>
bool is_scanned(const reference::BitVolume& volume) {
  const Limits limits{extent, extent};
  static uint8_t memory[Extractor32::minimum_bytes(Limits{extent, extent}) + (size_t{4} << 20)];
  Scanner extractor;
  return extractor.start(limits, 1, {memory, sizeof memory}, {nullptr, discard_event}) ==
             Status::ok &&
         is_pushed(extractor, volume) && extractor.finish() == Status::ok;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const bool is_host = std::string_view(argv[1]) == "host";
  const reference::BitVolume volume =
      reference::ball({extent, extent, extent}, {extent - 1, extent - 1, extent - 1}, 45 * 45);
  set_bits(volume);
  if (!counted_scan(is_host ? is_scanned<HostExtractor> : is_scanned<Extractor32>, volume))
    return 1;
  std::printf("%llu\n", static_cast<unsigned long long>(active_cells(volume)));
  return 0;
}
