// A joiner for more pieces than fit in memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <discmc/sink.hpp>
#include <optional>
#include <vector>

#include "files/temporary_file.hpp"
#include "meshing.hpp"
#include "surface/growing_joiner.hpp"

namespace discmc::command {

/// Accepts the events of a Joiner that is short of memory. A chain never leaves its plane, so
/// pieces are divided into 256 groups by plane, and the groups are joined one after another.
/// Memory: some megabytes while events arrive; later the pieces of one group. Disk: 4 bytes per
/// run, 8 with a normal, 16 per fragment or ring.
class PlaneSpill {
 public:
  /// sink: receives events outside regions at once, and the rest from join(). The sink must accept
  /// everything. Owner: the caller.
  explicit PlaneSpill(const Sink& sink) : sink_(sink) {}
  PlaneSpill(const PlaneSpill&) = delete;
  PlaneSpill& operator=(const PlaneSpill&) = delete;

  /// Always accepts the event. Throws std::runtime_error if the disk is full.
  SinkResult accept(const Event& event);

  /// Sends all regions, loose pieces and `finish` to the sink. Call it after the last event.
  void join();

 private:
  struct Block {
    std::uint64_t begin;  // offset in the file
    std::size_t words;
  };
  struct Group {
    std::vector<Block> blocks;
    std::vector<std::uint32_t> words;       // not written to the file yet
    std::uint64_t fragments = 0, runs = 0;  // number in the group
  };

  Group& group_of(Incidence incidence, const Vertex& vertex);
  void begin_ring(const Event& event);
  void append(const Event& event);
  void write(Group& group);
  void join(Group& group);
  void replay(const Group& group, GrowingJoiner& joiner);
  SinkResult pass(const Event& event);

  Sink sink_;
  std::optional<TemporaryFile> file_;  // created for the first block
  std::array<Group, 256> groups_;
  Group* group_ = nullptr;       // of the current region or fragment
  bool is_fragment_ = false;     // whether it is a fragment
  std::optional<Event> region_;  // waits for its first ring
  Event finish_{};
  Statistics totals_{};
  bool has_finish_ = false;
};

/// A GrowingJoiner for streams in any order. Beyond this much memory, it uses a temporary file.
class SpillingJoiner {
 public:
  /// sink: must accept everything; Owner: the caller. bytes: the limit for joiners.
  SpillingJoiner(const Sink& sink, std::uint64_t bytes) : spill_(sink) {
    const auto first = static_cast<std::size_t>(
        std::clamp<std::uint64_t>(bytes, Joiner::minimum_bytes(), GrowingJoiner::first_bytes));
    joiner_.emplace(sink, InputOrder::any, first, GrowingJoiner::Limit{bytes, make_sink(spill_)});
  }

  SinkResult accept(const Event& event) { return joiner_->accept(event); }

  /// Limit: call it after the last event.
  void finish() {
    joiner_->finish();
    joiner_.reset();  // frees memory for the spill
    spill_.join();
  }

 private:
  PlaneSpill spill_;
  std::optional<GrowingJoiner> joiner_;
};

}  // namespace discmc::command
