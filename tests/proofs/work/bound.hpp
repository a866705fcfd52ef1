// The bound on the work of a call, as lib/DESIGN.md publishes it ("Work").
#ifndef DISCMC_TESTS_WORK_BOUND_HPP
#define DISCMC_TESTS_WORK_BOUND_HPP

#include <algorithm>
#include <cstdint>
#include <discmc/extractor.hpp>

namespace discmc::work {

/// What the basic blocks of a call are counted by.
struct Asked {
  uint64_t voxels = 0;
  uint64_t rows = 0;       ///< of cells
  uint64_t cells = 0;      ///< active ones
  uint64_t delivered = 0;  ///< events
  bool runs_were_short = false;
};

/// Units: basic blocks of the code that GCC or Clang make with -O1.
struct Cost {
  static constexpr uint64_t call = 120;
  static constexpr uint64_t voxel = 4;
  static constexpr uint64_t row = 60;
  static constexpr uint64_t word = 25;
  static constexpr uint64_t cell = 650;
  static constexpr uint64_t probe = 4;
  static constexpr uint64_t step = 2;      ///< towards the root of a region
  static constexpr uint64_t fragment = 8;  ///< that might be spilled
  static constexpr uint64_t node = 4;      ///< of such a fragment
  static constexpr uint64_t delivered = 20;
};

/// What a cell can ask for at most.
struct CellCalls {
  static constexpr uint64_t table = 4;       ///< calls of the hash table
  static constexpr uint64_t root = 17;       ///< searches for a root
  static constexpr uint64_t fragments = 51;  ///< looked at, when runs are short
  static constexpr uint64_t nodes = 32;      ///< of each, unless it is spilled unseen
};

/// Runs count as short with fewer available, and with fewer than `spilled_unseen` every fragment
/// that was lengthened is spilled.
constexpr uint32_t spilled_unseen = 2 * CellReserve::runs;
constexpr uint32_t runs_kept(uint32_t runs) {
  return std::max(runs / 4, spilled_unseen);
}

class Bound {
 public:
  Bound(const Limits& limits, const Capacities& capacities)
      : words_(limits.row_words()),
        probes_(capacities.slots >= Frontier<uint32_t>::keys(limits.columns(), limits.cell_rows())
                    ? 1
                    : std::min(capacities.slots, HashTable<uint32_t>::window)),
        steps_(log2_of(capacities.regions)),
        nodes_(runs_kept(capacities.runs) > spilled_unseen ? CellCalls::nodes : 0) {}

  uint64_t of(const Asked& asked) const {
    const uint64_t spills = CellCalls::fragments * (Cost::fragment + nodes_ * Cost::node);
    const uint64_t cell = Cost::cell + CellCalls::table * probes_ * Cost::probe +
                          CellCalls::root * steps_ * Cost::step +
                          (asked.runs_were_short ? spills : 0);
    return Cost::call + asked.voxels * Cost::voxel +
           asked.rows * (Cost::row + words_ * Cost::word) + asked.cells * cell +
           asked.delivered * Cost::delivered;
  }

 private:
  static uint64_t log2_of(uint64_t number) {
    uint64_t log = 0;
    while (number >>= 1) ++log;
    return log;
  }

  uint64_t words_;
  uint64_t probes_;
  uint64_t steps_;
  uint64_t nodes_;
};

}  // namespace discmc::work

#endif
