// A joiner for more pieces than there is memory.
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

/// Takes the events of a Joiner that is short of memory. Chains never leave their plane, so the
/// pieces are divided by planes into groups, and these are joined one after another.
/// Memory: while events come, some megabytes; in the end what the pieces of one group take, of
/// which there are 256. Disk: 4 bytes per run, 8 with a normal, 16 per fragment or ring.
class PlaneSpill {
 public:
  /// sink: gets what belongs to no region at once, the rest from join(); it must take everything at
  /// once. Owner: the caller.
  explicit PlaneSpill(const Sink& sink) : sink_(sink) {}
  PlaneSpill(const PlaneSpill&) = delete;
  PlaneSpill& operator=(const PlaneSpill&) = delete;

  /// Always takes the event. Throws std::runtime_error where the disk is full.
  SinkResult accept(const Event& event);

  /// After the last event: gives the sink all regions, what is still loose, and `finish`.
  void join();

 private:
  struct Block {
    std::uint64_t begin;  // in the file
    std::size_t words;
  };
  struct Group {
    std::vector<Block> blocks;
    std::vector<std::uint32_t> words;       // not in the file yet
    std::uint64_t fragments = 0, runs = 0;  // of these
  };

  Group& group_of(Incidence incidence, const Vertex& vertex);
  void begin_ring(const Event& event);
  void append(const Event& event);
  void write(Group& group);
  void join(Group& group);
  void replay(const Group& group, GrowingJoiner& joiner);
  SinkResult pass(const Event& event);

  Sink sink_;
  std::optional<TemporaryFile> file_;  // from the first block on
  std::array<Group, 256> groups_;
  Group* group_ = nullptr;       // of the region or fragment under way
  bool is_fragment_ = false;     // what is under way
  std::optional<Event> region_;  // until its plane is known
  Event finish_{};
  Statistics totals_{};
  bool has_finish_ = false;
};

/// A GrowingJoiner for streams in any order that continues in a temporary file beyond this much
/// memory.
class SpillingJoiner {
 public:
  /// sink: must take everything at once; Owner: the caller. bytes: the most for joiners.
  SpillingJoiner(const Sink& sink, std::uint64_t bytes) : spill_(sink) {
    const auto first = static_cast<std::size_t>(
        std::clamp<std::uint64_t>(bytes, Joiner::minimum_bytes(), GrowingJoiner::first_bytes));
    joiner_.emplace(sink, InputOrder::any, first, GrowingJoiner::Limit{bytes, make_sink(spill_)});
  }

  SinkResult accept(const Event& event) { return joiner_->accept(event); }

  /// Limit: after the last event.
  void finish() {
    joiner_->finish();
    joiner_.reset();  // the memory is for the spill now
    spill_.join();
  }

 private:
  PlaneSpill spill_;
  std::optional<GrowingJoiner> joiner_;
};

}  // namespace discmc::command
