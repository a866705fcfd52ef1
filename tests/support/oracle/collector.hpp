// A sink for tests: assembles the regions of a scan and verifies everything.
//
// Checks every event against the grammar of sink.hpp, and against the promises of earlier events.
// Loose fragments are checked and kept, not joined (naive_join.hpp).
#pragma once

#include <cstdint>
#include <discmc/limits.hpp>
#include <discmc/sink.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "region.hpp"

namespace discmc::reference {

/// Thrown by Collector::accept() if the sender breaks the grammar or a promise.
struct GrammarError : std::logic_error {
  using std::logic_error::logic_error;
};

struct LayerMark {
  uint32_t slice;
  size_t regions;  ///< number delivered before the mark
};

struct SkippedRow {
  uint32_t slice, row;
  bool is_repeated;
};

/// A loose fragment.
struct Fragment {
  Incidence incidence;
  Vertex start;
  Direction came;
  std::vector<Run> runs;
};

/// Collects one scan. The regions have sweep rings, in the order of arrival.
class Collector {
 public:
  explicit Collector(const Slab& slab = {}) : slab_(slab) {}

  /// Always returns `accepted`. Errors: throws GrammarError.
  SinkResult accept(const Event& event);

  /// Owner: the collector must outlive the sink.
  Sink sink() { return make_sink(*this); }

  const std::vector<Region>& regions() const { return regions_; }
  const std::vector<LayerMark>& layers() const { return layers_; }
  const std::vector<SkippedRow>& skipped() const { return skipped_; }
  bool is_finished() const { return state_ == State::over; }
  bool was_abandoned() const { return was_abandoned_; }
  /// Returns the statistics of the finish event. Limit: is_finished().
  const Statistics& statistics() const { return statistics_; }
  /// Returns loose fragments in the order of arrival.
  const std::vector<Fragment>& loose() const { return loose_; }
  /// Returns the number of neighbouring runs that could have been one run, in one ring or fragment.
  uint64_t split_sides() const { return split_sides_; }

 private:
  enum class State : uint8_t { between, region, ring, fragment, over };

  void begin_region(const Event& event);
  void begin_ring(const Event& event);
  void add_run(const Run& run);
  void end_ring();
  void end_region();
  void begin_fragment(const Event& event);
  void end_fragment();
  void add_skipped(const Event& event);
  void add_layer(const Event& event);
  void finish(const Event& event);
  /// Returns the index of the current slice, which the next layer mark closes.
  uint32_t slice() const {
    return slab_.first - (slab_.continues_below ? 1U : 0U) + static_cast<uint32_t>(layers_.size());
  }
  uint32_t own_slices() const {
    const uint32_t context = (slab_.continues_below ? 1U : 0U) + (slab_.continues_above ? 1U : 0U);
    const auto marked = static_cast<uint32_t>(layers_.size());
    return marked > context ? marked - context : 0;
  }

  State state_ = State::between;
  Slab slab_;
  Region region_{};
  int32_t plane_ = 0;
  Vertex start_{};
  Direction came_ = 0;
  bool hole_ = false;
  Run last_run_{};
  std::vector<Run> runs_;  // of the current ring or fragment

  std::vector<Region> regions_;
  std::vector<Fragment> loose_;
  std::vector<LayerMark> layers_;
  std::vector<SkippedRow> skipped_;
  Statistics statistics_{};
  bool was_abandoned_ = false;
  uint64_t rings_ = 0;
  uint64_t links_ = 0;
  uint64_t split_sides_ = 0;
};

/// Returns the vertices at which the links of runs start.
Ring vertices_of(Incidence incidence, Vertex vertex, const std::vector<Run>& runs);

/// Returns the simple rings of regions with sweep rings. Splits every ring at recurring vertices,
/// drops rings of two links, and puts the outer ring first.
std::vector<Region> simple_rings(const std::vector<Region>& regions);

}  // namespace discmc::reference
