// A scan whose work is counted for each call.
#pragma once

#include <algorithm>
#include <discmc/extractor.hpp>
#include <vector>

#include "oracle/scan.hpp"
#include "oracle/volume.hpp"
#include "proofs/work/bound.hpp"

namespace discmc::work {

/// Executed basic blocks of the library.
extern uint64_t blocks;

/// The memory of a scan.
struct Room {
  const char* name;
  Capacities capacities;
};

/// Maxima over the calls of a scan.
struct Work {
  double max_of_bound = 0;  ///< maximum of work divided by bound
  double max_at_work = 0;   ///< the same, for calls that visited vertices
  uint64_t max_blocks = 0;  ///< blocks of a push
  uint64_t blocks = 0;      ///< of all calls
  uint64_t vertices = 0;
  uint64_t fragments = 0;
};

/// Scans a volume row by row. Errors: throws on any error of the extractor.
class CountedScan {
 public:
  CountedScan(const reference::BitVolume& volume, Border border, const Room& room)
      : volume_(volume),
        room_(room),
        limits_{volume.width, volume.height, border},
        memory_(Extractor32::bytes_for(limits_, room.capacities)) {
    reference::require_ok(extractor_.start(limits_, room.capacities, 1,
                                           {memory_.data(), memory_.size()}, make_sink(counter_)));
  }

  Work run() {
    for (uint32_t z = 0; z < volume_.depth; ++z) {
      int32_t swept = first_row();
      for (uint32_t y = 0; y < volume_.height; ++y) {
        const int32_t ready = ready_rows(y, z);
        Asked asked = sweep_of(z, swept, ready);
        asked.voxels = volume_.width;
        const uint8_t* const row = volume_.on.data() + volume_.index(0, y, z);
        count(asked, [&] { return extractor_.push(row, volume_.width).status; });
        swept = ready;
      }
    }
    const size_t pushes = calls_.size();
    count(sweep_of(volume_.depth, first_row(), end_row()), [&] { return extractor_.finish(); });
    return sum(pushes);
  }

 private:
  struct Counter {
    uint64_t events = 0, holes = 0, hole_runs = 0;
    bool is_in_hole = false;
    SinkResult accept(const Event& event) {
      // A long side is kept in pieces (detail::trace::is_full_side()).
      events += 1 + event.run.length() / 680;
      if (event.kind == Event::Kind::ring || event.kind == Event::Kind::fragment)
        holes += is_in_hole = event.is_hole;
      if (event.kind == Event::Kind::run) hole_runs += is_in_hole;
      return SinkResult::accepted;
    }
  };
  struct Call {
    Asked asked;
    uint64_t call_blocks;
  };

  // The swept rows of voxels, and the first row of the halo.
  int32_t first_row() const { return limits_.border == Border::closed ? -1 : 0; }
  int32_t end_row() const { return static_cast<int32_t>(limits_.height); }
  // Returns the last row below slice z that can be swept when its row y has arrived.
  int32_t ready_rows(uint32_t y, uint32_t z) const {
    if (limits_.border == Border::open && z == 0) return 0;
    if (y + 1 == volume_.height) return end_row();
    return static_cast<int32_t>(y);
  }

  // Returns the work that the rows from `first` to `end` - 1 of the slice below slice z require.
  Asked sweep_of(uint32_t z, int32_t first, int32_t end) const {
    const int32_t slice = static_cast<int32_t>(z) - 1;
    const auto differ = [&](const Vertex& a, const Vertex& b) {
      const bool is_edge = limits_.border == Border::closed ||
                           (volume_.contains(a.x, a.y, a.z) && volume_.contains(b.x, b.y, b.z));
      return is_edge && volume_.at(a.x, a.y, a.z) != volume_.at(b.x, b.y, b.z);
    };
    Asked asked;
    for (int32_t y = first; y < end; ++y) {
      ++asked.rows;
      for (int32_t x = -1; x < static_cast<int32_t>(limits_.width); ++x) {
        const Vertex here{x, y, slice};
        for (const Vertex& step : {Vertex{1, 0, 0}, Vertex{0, 1, 0}, Vertex{0, 0, 1}})
          if (differ(here, here + step)) ++asked.vertices;
      }
    }
    return asked;
  }

  template <class Function>
  void count(Asked asked, Function call) {
    const uint64_t events = counter_.events;
    const uint64_t before = blocks;
    const Status status = call();
    const uint64_t call_blocks = blocks - before;
    reference::require_ok(status);
    asked.delivered = counter_.events - events;
    asked.is_short = room_.capacities.slots < extractor_.peaks().slots + min_spare;
    calls_.push_back({asked, call_blocks});
  }

  Work sum(size_t pushes) const {
    Work work;
    for (size_t i = 0; i < calls_.size(); ++i) {
      const auto& [asked, call_blocks] = calls_[i];
      const double share =
          static_cast<double>(call_blocks) /
          static_cast<double>(bound(limits_.width, asked, counter_.holes, counter_.hole_runs));
      work.max_of_bound = std::max(work.max_of_bound, share);
      if (asked.vertices > 0) work.max_at_work = std::max(work.max_at_work, share);
      if (i < pushes) work.max_blocks = std::max(work.max_blocks, call_blocks);
      work.blocks += call_blocks;
      work.vertices += asked.vertices;
    }
    work.fragments = extractor_.statistics().fragments;
    return work;
  }

  static constexpr uint32_t min_spare =
      detail::trace::Fragments<uint32_t, detail::trace::NoNormal>::min_spare_to_hold;

  const reference::BitVolume& volume_;
  Room room_;
  Limits limits_;
  std::vector<uint8_t> memory_;
  Counter counter_;
  Extractor32 extractor_;
  std::vector<Call> calls_;
};

}  // namespace discmc::work
