// A surface as one hash per region, so that large surfaces can be compared. The hashes depend
// neither on the order of regions and holes nor on where rings start.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <discmc/chain.hpp>
#include <discmc/sink.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/event_log.hpp"
#include "oracle/surface.hpp"

namespace discmc::torture {

/// A sink for whole regions. Errors: throws if a loose fragment arrives.
class Surface {
 public:
  /// Subtracts the slices below, so that regions compare equal at any height.
  explicit Surface(uint32_t slices_below) : lift_(2 * static_cast<int32_t>(slices_below)) {}

  SinkResult accept(const Event& event) {
    switch (event.kind) {
      case Event::Kind::region:
        incidence_ = event.incidence;
        region_ = {incidence_, {}};
        rings_ = 0;
        break;
      case Event::Kind::ring:
        end_ring();
        begin_ring(event);
        break;
      case Event::Kind::run:
        add_run(event.run);
        break;
      case Event::Kind::region_end:
        end_ring();
        region_.number = reference::mix(region_.number);
        regions_.push_back(region_);
        break;
      case Event::Kind::finish:
        counts_ = reference::counts(*event.statistics);
        break;
      case Event::Kind::fragment:
        throw std::runtime_error("a fragment that nothing joins");
      default:
        break;
    }
    return SinkResult::accepted;
  }

  /// Returns how this surface, of a volume with this many seams, differs from that of the whole
  /// volume; empty if it does not.
  std::string difference(Surface& other, size_t seams) {
    sort();
    other.sort();
    // A seam may hide one of each.
    for (size_t i = 0; i < counted; ++i)
      if (counts_[i] > other.counts_[i] || counts_[i] + seams < other.counts_[i])
        return "other counts of cells, facets or triangles";
    const size_t count = std::min(regions_.size(), other.regions_.size());
    for (size_t i = 0; i < count; ++i)
      if (regions_[i].number != other.regions_[i].number)
        return regions_[i].number < other.regions_[i].number ? "unexpected " + regions_[i].text()
                                                             : "no " + other.regions_[i].text();
    if (regions_.size() > count) return "unexpected " + regions_[count].text();
    return other.regions_.size() > count ? "no " + other.regions_[count].text() : "";
  }

  size_t regions() const { return regions_.size(); }

 private:
  static constexpr size_t counted = 3;  // counts that do not depend on the division of a volume

  struct Region {
    Incidence incidence;
    Vertex start;  // of the outer ring, for messages
    uint64_t number = 0;

    std::string text() const {
      return "region of incidence " + std::to_string(incidence) + " at " + std::to_string(start.x) +
             ", " + std::to_string(start.y) + ", " + std::to_string(start.z);
    }
  };

  void begin_ring(const Event& event) {
    at_ = start_ = event.start;
    at_.z -= lift_;
    start_.z -= lift_;
    if (rings_++ == 0) region_.start = start_;
    is_hole_ = event.is_hole;
    ring_ = runs_ = 0;
  }

  void add_run(const Run& run) {
    if (runs_++ == 0)
      first_ = run.direction();
    else
      turn(last_, run.direction(), at_);
    last_ = run.direction();
    translate(at_, incidence_, last_, run.length());
  }

  // Adds the corners of a ring to its hash.
  void turn(Direction in, Direction out, const Vertex& corner) {
    if (in == out) return;
    const auto part = [](int32_t value) {
      return static_cast<uint64_t>(static_cast<uint32_t>(value));
    };
    uint64_t number = reference::mix(part(corner.x) << 32 | part(corner.y));
    number = reference::mix(number + part(corner.z));
    ring_ += reference::mix(number + (uint64_t{in} << 8 | uint64_t{out} << 16 | incidence_));
  }

  void end_ring() {
    if (rings_ == 0 || runs_ == 0) return;
    if (at_ != start_) throw std::runtime_error("a ring that is not closed");
    turn(last_, first_, start_);
    region_.number += reference::mix(ring_ + (is_hole_ ? 1 : 0));
    runs_ = 0;
  }

  void sort() {
    std::sort(regions_.begin(), regions_.end(),
              [](const Region& a, const Region& b) { return a.number < b.number; });
  }

  int32_t lift_;
  std::vector<Region> regions_;
  std::array<uint64_t, 8> counts_{};

  // The current region and ring.
  Region region_{};
  Incidence incidence_ = 0;
  uint32_t rings_ = 0, runs_ = 0;
  Vertex start_{}, at_{};
  Direction first_ = 0, last_ = 0;
  bool is_hole_ = false;
  uint64_t ring_ = 0;
};

}  // namespace discmc::torture
