// Every block of a few voxels there is: the sweep finds the regions that the definition demands.
//
// A fingerprint of the regions is compared for every block, the regions themselves, ring for ring,
// with the paper's Merge for a sample. Under an address sanitizer only every 37th of the large
// blocks is swept.
#include <doctest/doctest.h>

#include "oracle/merge.hpp"
#include "oracle/sanitized.hpp"
#include "oracle/scan.hpp"
#include "oracle/surface.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// One extractor for all the blocks of a size: reset() is part of what is tested.
class BlockScanner {
 public:
  BlockScanner(Size size, bool closed)
      : limits_{size.width, size.height, closed ? Border::closed : Border::open},
        memory_(bytes_for<uint16_t>(limits_, capacities())) {}

  /// The regions of a block, in sweep rings; they stay valid until the next scan.
  const std::vector<Region>& scan(const BitVolume& volume) {
    collector_ = Collector();
    if (!is_started_)
      require_ok(extractor_.start(limits_, capacities(), 1, memory_.memory(), collector_.sink()));
    else
      require_ok(extractor_.reset());
    is_started_ = true;
    push_all(extractor_, volume.on);
    finish_all(extractor_);
    return collector_.regions();
  }

  bool is_intact() const { return memory_.is_intact(); }

 private:
  Capacities capacities() const {
    Capacities capacities = worst_case_capacities(limits_);
    capacities.runs = 3 * capacities.runs + 500;
    return capacities;
  }

  Limits limits_;
  Block memory_;
  Collector collector_;
  Extractor<uint16_t> extractor_;
  bool is_started_ = false;
};

// A description of the first block with other regions than the definition demands, or nothing.
std::string first_difference(const std::string& name, const std::vector<Region>& swept,
                             const BitVolume& volume, bool closed) {
  return name + ": " +
         describe_difference(canonical(simple_rings(swept)), canonical(merge(volume, closed)));
}

std::string sweep_all(Size size, bool closed, uint64_t sample, uint64_t stride = 1) {
  BlockScanner scanner(size, closed);
  const uint64_t blocks = uint64_t{1} << size.width * size.height * size.depth;
  for (uint64_t bits = 0; bits < blocks; bits += stride) {
    const std::string name = "block " + std::to_string(bits);
    const BitVolume volume = from_bits(size, bits);
    try {
      const std::vector<Region>& swept = scanner.scan(volume);
      if (fingerprint(swept) != fingerprint_of_cells(volume, closed))
        return first_difference(name, swept, volume, closed);
      if (closed && surface_of(swept).open_links != 0) return name + ": not closed";
      if (bits / stride % sample != 0) continue;
      if (canonical(simple_rings(swept)) != canonical(merge(volume, closed)))
        return first_difference(name, swept, volume, closed);
    } catch (const std::exception& error) {
      return name + ": " + error.what();
    }
  }
  return scanner.is_intact() ? "" : "a write outside the arena";
}

void check_all(Size size, uint64_t sample, uint64_t stride = 1) {
  CAPTURE(size.width);
  CAPTURE(size.height);
  CAPTURE(size.depth);
  CHECK(sweep_all(size, true, sample, stride) == "");
  CHECK(sweep_all(size, false, sample, stride) == "");
}

}  // namespace

TEST_CASE("every block of a row, a sheet or a cube of two voxels is swept as the paper merges it") {
  check_all({1, 1, 1}, 1);
  check_all({1, 1, 5}, 1);
  check_all({1, 5, 1}, 1);
  check_all({5, 1, 1}, 1);
  check_all({1, 3, 3}, 1);
  check_all({3, 1, 3}, 1);
  check_all({3, 3, 1}, 1);
  check_all({2, 2, 2}, 1);
}

TEST_CASE("every block of two cells is swept as the paper merges it") {
  check_all({2, 2, 3}, 3);
  check_all({2, 3, 2}, 3);
  check_all({3, 2, 2}, 3);
}

TEST_CASE("every block of 2 x 3 x 3 voxels is swept as the paper merges it") {
  check_all({2, 3, 3}, 101, step(37));
}

TEST_CASE("every block of 3 x 2 x 3 voxels is swept as the paper merges it") {
  check_all({3, 2, 3}, 101, step(37));
}

TEST_CASE("every block of 3 x 3 x 2 voxels is swept as the paper merges it") {
  check_all({3, 3, 2}, 101, step(37));
}

TEST_CASE("a block of every kind of larger tiling is swept as the paper merges it") {
  for (uint64_t bits = 0; bits < 256; ++bits)
    for (const bool closed : {true, false}) {
      const BitVolume volume = tiling({5, 5, 5}, static_cast<Configuration>(bits));
      BlockScanner scanner({5, 5, 5}, closed);
      CAPTURE(bits);
      CAPTURE(closed);
      CHECK(canonical(simple_rings(scanner.scan(volume))) == canonical(merge(volume, closed)));
    }
}
