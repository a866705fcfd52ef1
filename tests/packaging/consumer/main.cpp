// One voxel in the middle of a volume: its surface is an octahedron, eight regions.
#include <discmc/extractor.hpp>

namespace {

uint8_t memory[4096];

struct Counter {
  unsigned regions = 0;

  discmc::SinkResult accept(const discmc::Event& event) {
    if (event.kind == discmc::Event::Kind::region) ++regions;
    return discmc::SinkResult::accepted;
  }
};

}  // namespace

int main() {
  constexpr discmc::Limits limits{3, 3};
  constexpr uint8_t volume[27] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  Counter counter;
  discmc::Extractor16 extractor;
  if (extractor.start(limits, 1, discmc::memory_of(memory), discmc::make_sink(counter)) !=
      discmc::Status::ok)
    return 1;
  if (extractor.push(volume, 27).status != discmc::Status::ok) return 2;
  if (extractor.finish() != discmc::Status::ok) return 3;
  return counter.regions == 8 ? 0 : 4;
}
