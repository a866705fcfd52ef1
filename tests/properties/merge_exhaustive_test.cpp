// All blocks of a few voxels: the sweep finds the regions that the definition requires.
//
// A fingerprint of the regions is compared for every block. For a sample, the regions are compared
// ring for ring with the paper's Merge. Under an address sanitizer, one in 37 of the large blocks
// is swept.
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "oracle/surface.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// One extractor for all blocks of a size, so that reset() is tested, too.
class BlockScanner {
 public:
  BlockScanner(Size size, bool is_closed, const Capacities& capacities)
      : limits_{size.width, size.height, is_closed ? Border::closed : Border::open},
        memory_(Extractor16::bytes_for(limits_, capacities)) {
    require_ok(extractor_.start(limits_, capacities, 1, memory_.memory(), make_sink(collector_)));
  }

  /// The surface of a block, in sweep rings; valid until the next scan.
  const Collector& scan(const BitVolume& volume) {
    collector_ = Collector();
    require_ok(extractor_.reset());
    push_all(extractor_, volume.on);
    finish_all(extractor_);
    return collector_;
  }

  bool is_intact() const { return memory_.is_intact(); }

 private:
  Limits limits_;
  Block memory_;
  Collector collector_;
  Extractor<uint16_t> extractor_;
};

constexpr Capacities plenty{2000, 2000};

// Calls check(number, volume) for every block, or one in `stride`, until it returns a fault.
template <class Check>
std::string for_each_block(Size size, uint64_t stride, Check check) {
  const uint64_t blocks = uint64_t{1} << size.width * size.height * size.depth;
  for (uint64_t bits = 0; bits < blocks; bits += stride) {
    std::string fault;
    try {
      fault = check(bits / stride, from_bits(size, bits));
    } catch (const std::exception& error) {
      fault = error.what();
    }
    if (!fault.empty()) return "block " + std::to_string(bits) + ": " + fault;
  }
  return {};
}

// Describes the first block whose regions differ from the definition; empty if there is none.
std::string sweep_all(Size size, bool is_closed, uint64_t sample, uint64_t stride = 1) {
  BlockScanner scanner(size, is_closed, plenty);
  const std::string fault =
      for_each_block(size, stride, [&](uint64_t number, const BitVolume& volume) -> std::string {
        const Collector& swept = scanner.scan(volume);
        if (!swept.loose().empty()) return "loose fragments, with memory left";
        if (fingerprint(swept.regions()) != fingerprint_of_cells(volume, is_closed))
          return "other regions: " + unlike_merge(swept.regions(), volume, is_closed);
        if (is_closed && surface_of(swept.regions()).open_links != 0) return "not closed";
        return number % sample == 0 ? unlike_merge(swept.regions(), volume, is_closed) : "";
      });
  return scanner.is_intact() ? fault : "a write outside the arena";
}

// Describes the first block whose loose fragments do not join to the regions with ample memory.
// Tries every number of slots from the minimum to `most`.
std::string press_all(Size size, bool is_closed, uint32_t most, uint64_t stride) {
  BlockScanner scanner(size, is_closed, plenty);
  std::vector<std::unique_ptr<BlockScanner>> loose;
  for (uint32_t slots = minimum_capacities().slots; slots <= most; ++slots) {
    const Capacities few{slots, slots / 8};
    loose.push_back(std::make_unique<BlockScanner>(size, is_closed, few));
  }
  return for_each_block(size, stride, [&](uint64_t number, const BitVolume& volume) -> std::string {
    const std::vector<Region> whole = scanner.scan(volume).regions();
    const size_t turn = number % loose.size();
    const std::string unlike = unlike_joined({loose[turn]->scan(volume)}, whole);
    if (!unlike.empty()) return unlike;
    return loose[turn]->is_intact() ? "" : "a write outside the arena";
  });
}

void check_all(Size size, uint64_t sample, uint64_t stride = 1) {
  for (const bool is_closed : {true, false}) {
    INFO("width ", size.width, ", height ", size.height, ", depth ", size.depth, ", is_closed ",
         is_closed);
    CHECK(sweep_all(size, is_closed, sample, stride) == "");
  }
}

void press_all(Size size, uint64_t stride = 1) {
  for (const bool is_closed : {true, false})
    for (const uint32_t most : {minimum_capacities().slots, 20U}) {
      INFO("width ", size.width, ", height ", size.height, ", depth ", size.depth, ", is_closed ",
           is_closed);
      CHECK(press_all(size, is_closed, most, stride) == "");
    }
}

}  // namespace

TEST_CASE("every block of a row, sheet or 2 x 2 x 2 cube is swept as in the paper") {
  check_all({1, 1, 1}, 1);
  check_all({1, 1, 5}, 1);
  check_all({1, 5, 1}, 1);
  check_all({5, 1, 1}, 1);
  check_all({1, 3, 3}, 1);
  check_all({3, 1, 3}, 1);
  check_all({3, 3, 1}, 1);
  check_all({2, 2, 2}, 1);
}

TEST_CASE("every block of two cells is swept as in the paper") {
  check_all({2, 2, 3}, 3);
  check_all({2, 3, 2}, 3);
  check_all({3, 2, 2}, 3);
}

TEST_CASE("blocks of 2 x 3 x 3 voxels are swept as in the paper") {
  check_all({2, 3, 3}, 101, step(37));
}

TEST_CASE("blocks of 3 x 2 x 3 voxels are swept as in the paper") {
  check_all({3, 2, 3}, 101, step(37));
}

TEST_CASE("blocks of 3 x 3 x 2 voxels are swept as in the paper") {
  check_all({3, 3, 2}, 101, step(37));
}

TEST_CASE("every block of two cells in minimal memory is the same after joining") {
  press_all({2, 2, 2});
  press_all({2, 2, 3}, step(7));
  press_all({2, 3, 2}, step(7));
  press_all({3, 2, 2}, step(7));
}

TEST_CASE("larger blocks in minimal memory are the same after joining") {
  press_all({2, 3, 3}, 101 * step(37));
  press_all({3, 2, 3}, 101 * step(37));
  press_all({3, 3, 2}, 101 * step(37));
}

TEST_CASE("a 5 x 5 x 5 block of every tiling pattern is swept as in the paper") {
  for (uint64_t bits = 0; bits < 256; ++bits)
    for (const bool is_closed : {true, false}) {
      const BitVolume volume = tiling({5, 5, 5}, static_cast<Configuration>(bits));
      BlockScanner scanner({5, 5, 5}, is_closed, ample);
      INFO("bits ", bits, ", is_closed ", is_closed);
      CHECK(unlike_merge(scanner.scan(volume).regions(), volume, is_closed) == "");
    }
}
