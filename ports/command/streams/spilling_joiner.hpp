// A joiner for more pieces than there is memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "meshing.hpp"
#include "plane_spill.hpp"
#include "surface/growing_joiner.hpp"

namespace discmc::command {

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
