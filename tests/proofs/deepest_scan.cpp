// A scan up to the last slice that a z coordinate can count. The surface of the last slices equals
// that of the first ones, and one more slice is refused. The test pushes more slices than 24 bits
// can count. With --all (scripts/check/prove) it pushes all slices: a thousand million in 90
// seconds.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <discmc/extractor.hpp>
#include <vector>

using namespace discmc;

namespace {

// The delivered events, with z relative to a slice. Layers are only counted.
class Log {
 public:
  explicit Log(uint32_t slice) : origin_(2 * static_cast<int32_t>(slice)) {}
  SinkResult accept(const Event& event) {
    layers += event.kind == Event::Kind::layer;
    if (event.kind == Event::Kind::region) words.push_back(event.incidence);
    if (event.kind == Event::Kind::run) words.push_back(static_cast<int32_t>(event.run.code()));
    if (event.kind == Event::Kind::ring)
      words.insert(words.end(), {event.start.x, event.start.y, event.start.z - origin_});
    return SinkResult::accepted;
  }

  std::vector<int32_t> words;
  uint32_t layers = 0;

 private:
  int32_t origin_;
};

// A volume with one on voxel in each of the last three of `slices` slices. The scan begins at slice
// `first`, and has one slice more.
bool scan(uint32_t first, uint32_t slices, Status beyond, Log& log) {
  static uint8_t memory[Extractor16::minimum_bytes({1, 1}) + 2000];
  const Slab slab{first, first > 0};
  Extractor16 extractor;
  if (extractor.start({1, 1, Border::closed, slab}, 1, memory_of(memory), make_sink(log)) !=
      Status::ok)
    return false;
  for (uint32_t slice = slab.continues_below ? first - 1 : 0; slice < slices; ++slice) {
    const uint8_t voxel = slice + 3 < slices ? 0 : 1;
    if (extractor.push_bits(&voxel).status != Status::ok) return false;
  }
  const uint8_t off = 0;
  return extractor.push_bits(&off).status == beyond && extractor.finish() == Status::ok;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr uint32_t few = 5, share = (1U << 24) + 8;
  const bool takes_all = argc == 2 && std::strcmp(argv[1], "--all") == 0;
  const uint32_t first = takes_all ? 0 : Limits::max_slices - share;
  // The context slice below ends with a layer mark, too.
  const uint32_t layers = Limits::max_slices - first + (first > 0 ? 1 : 0);
  Log shallow(few);
  Log deep(Limits::max_slices);
  const bool good = scan(0, few, Status::ok, shallow) &&
                    scan(first, Limits::max_slices, Status::too_many_slices, deep) &&
                    deep.layers == layers && deep.words == shallow.words && !deep.words.empty();
  if (!good) std::fputs("deepest_scan: the last slices are not as the first\n", stderr);
  return good ? 0 : 1;
}
