// A scan whose work is counted, call by call.
#ifndef DISCMC_TESTS_WORK_COUNTED_SCAN_HPP
#define DISCMC_TESTS_WORK_COUNTED_SCAN_HPP

#include <stdexcept>
#include <vector>

#include "oracle/volume.hpp"
#include "proofs/work/bound.hpp"

namespace discmc::work {

/// Basic blocks of the library that were executed so far.
extern uint64_t blocks;

/// The memory of a scan.
struct Room {
  const char* name;
  Capacities capacities;
  bool takes_fragments;
};

/// What the calls of a scan came to.
struct Work {
  double most_of_bound = 0;  ///< the greatest share of its bound that a call took
  double most_at_work = 0;   ///< the same of calls that met active cells
  uint64_t most = 0;         ///< blocks of a push
  uint64_t blocks = 0;       ///< of all calls
  uint64_t cells = 0;
  uint64_t fragments = 0;
};

/// Scans a volume row by row. Errors: throws what the extractor reports.
class CountedScan {
 public:
  CountedScan(const reference::BitVolume& volume, Border border, const Room& room)
      : volume_(volume),
        limits_{volume.width, volume.height, border},
        runs_{room.capacities.runs},
        bound_(limits_, room.capacities),
        memory_(bytes_for<uint32_t>(limits_, room.capacities)) {
    require_ok(extractor_.start(limits_, room.capacities, 1, {memory_.data(), memory_.size()},
                                sink_to(counter_, room.takes_fragments)));
  }

  Work run() {
    for (uint32_t z = 0; z < volume_.depth; ++z) {
      uint32_t swept = 0;
      for (uint32_t y = 0; y < volume_.height; ++y) {
        const uint32_t ready = ready_rows(y, z);
        Asked asked = sweep_of(z, swept, ready);
        asked.voxels = volume_.width;
        const uint8_t* const row = volume_.on.data() + volume_.index(0, y, z);
        count(asked, [&] { return extractor_.push(row, volume_.width).status; });
        swept = ready;
      }
    }
    const uint64_t most = work_.most;
    count(sweep_of(volume_.depth, 0, limits_.cell_rows()), [&] { return extractor_.finish(); });
    work_.most = most;
    work_.fragments = extractor_.statistics().fragments;
    return work_;
  }

 private:
  struct Counter {
    uint64_t events = 0;
    Answer take(const Event&) {
      ++events;
      return Answer::taken;
    }
  };

  static void require_ok(Status status) {
    if (status != Status::ok) throw std::runtime_error(text(status));
  }

  // Rows of cells below slice z that can be swept once its row y is there.
  uint32_t ready_rows(uint32_t y, uint32_t z) const {
    if (limits_.border == Border::open && z == 0) return 0;
    if (y + 1 == volume_.height) return limits_.cell_rows();
    return limits_.border == Border::closed ? y + 1 : y;
  }

  // What the rows of cells from `first` to `end` - 1 below slice z ask for.
  Asked sweep_of(uint32_t z, uint32_t first, uint32_t end) const {
    const auto halo = static_cast<int32_t>(limits_.halo());
    Asked asked;
    asked.rows = end - first;
    for (uint32_t row = first; row < end; ++row)
      for (uint32_t column = 0; column < limits_.columns(); ++column) {
        const Configuration configuration =
            volume_.configuration({static_cast<int32_t>(column) - halo,
                                   static_cast<int32_t>(row) - halo, static_cast<int32_t>(z) - 1});
        asked.cells += configuration != 0 && configuration != 255;
      }
    return asked;
  }

  template <class Call>
  void count(Asked asked, Call call) {
    const uint64_t events = counter_.events;
    const uint64_t before = blocks;
    const Status status = call();
    const uint64_t taken = blocks - before;
    require_ok(status);
    asked.delivered = counter_.events - events;
    asked.runs_were_short = runs_ - extractor_.high_water().runs < runs_kept(runs_);
    const double share = static_cast<double>(taken) / static_cast<double>(bound_.of(asked));
    work_.most_of_bound = std::max(work_.most_of_bound, share);
    if (asked.cells > 0) work_.most_at_work = std::max(work_.most_at_work, share);
    work_.most = std::max(work_.most, taken);
    work_.blocks += taken;
    work_.cells += asked.cells;
  }

  const reference::BitVolume& volume_;
  Limits limits_;
  uint32_t runs_;
  Bound bound_;
  std::vector<uint8_t> memory_;
  Counter counter_;
  Extractor32 extractor_;
  Work work_;
};

}  // namespace discmc::work

#endif
