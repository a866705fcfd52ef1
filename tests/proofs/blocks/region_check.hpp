// A sink that checks the surface of a small block event by event. It reduces the surface to a few
// words, which can be saved and restored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <discmc/limits.hpp>
#include <discmc/sink.hpp>
#include <vector>

namespace discmc::prove {

/// A table of the lattice of a block of 3 x 3 x 3 voxels with its halo.
class Lattice {
 public:
  static constexpr int32_t first = -1, last = 5;  ///< coordinates. Units: half-steps
  static constexpr int32_t side = last - first + 1;
  static constexpr size_t vertices = size_t{side} * side * side;

  struct Step {
    uint64_t hash;  ///< hashed as by reference::fingerprint()
    int16_t to;     ///< -1 if the link leaves the lattice
    bool is_inner;  ///< not on a face where an open volume ends
  };

  explicit Lattice(Border border);

  static bool contains(const Vertex& vertex);
  static size_t index(const Vertex& vertex);
  static Vertex vertex(size_t index);
  const Step& step(size_t from, Link link) const { return steps_[from * link_codes + link]; }

 private:
  std::vector<Step> steps_;  // by vertex and link
};

/// Checks that every ring is closed, turns according to its hole flag, and uses each directed link
/// once. Errors: accept() throws std::runtime_error.
class RegionCheck {
 public:
  /// The sums over the regions so far; plain data.
  struct Sum {
    uint64_t fingerprint = 0;                  ///< as of reference::fingerprint()
    uint32_t links = 0;                        ///< of all rings
    int32_t unpaired = 0;                      ///< inner links without their opposite
    uint32_t is_used[Lattice::vertices] = {};  ///< by vertex: a bit per link that starts there
  };

  explicit RegionCheck(const Lattice& lattice) : lattice_(lattice) {}

  SinkResult accept(const Event& event);

  const Sum& sum() const { return sum_; }
  void go_back(const Sum& sum) { sum_ = sum; }

 private:
  void begin_ring(const Event& event);
  void add_run(Run run);
  void end_ring() const;

  const Lattice& lattice_;
  Sum sum_;
  Incidence incidence_ = no_incidence;
  uint32_t rings_ = 0;  // of the region
  bool hole_ = false;
  size_t start_ = 0;
  size_t at_ = 0;
  int32_t area_ = 0;
  uint64_t boundary_ = 0;
};

}  // namespace discmc::prove
