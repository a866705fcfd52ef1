// The sweep: hands the passes at the vertices of a row to the fragments. It may be suspended
// between any two of them.
#ifndef DISCMC_TRACE_SWEEP_HPP
#define DISCMC_TRACE_SWEEP_HPP

#include <discmc/trace/delivery.hpp>
#include <discmc/trace/derived_passes.hpp>

namespace discmc::trace {

template <class Index, class Normal>
class Sweep {
 public:
  /// Whether the slice below a slab is swept, too. If not, what comes from there is lost.
  static constexpr bool opens_seams = false;

  Fragments<Index, Normal>& fragments() { return fragments_; }
  Delivery<Index, Normal>& delivery() { return delivery_; }
  const Fragments<Index, Normal>& fragments() const { return fragments_; }
  const Delivery<Index, Normal>& delivery() const { return delivery_; }

  void clear() {
    fragments_.clear();
    delivery_.clear();
    passes_.clear();
    counts_ = {};
  }
  /// Forgets all addresses.
  void forget() { fragments_.set_at_seam(nullptr); }

  /// Sweeps a row, or goes on with it. False when the sink said "not now": call again.
  template <class Normals>
  bool sweep(const SweptRow& row, const Normals& normals, const Sink& sink, Statistics& statistics);

  /// After the last vertex: delivers holes that still wait, loose. As sweep().
  bool settle_holes(const Sink& sink, Statistics& statistics) {
    return delivery_.settle_holes(fragments_, sink, statistics);
  }

  /// For a sweep that has come as far as a word of a row in another way: what it has counted, and
  /// where to go on.
  SweepCounts& counts() { return counts_; }
  void go_on_from(uint32_t word) { passes_.go_on_from(word); }

 private:
  DerivedPasses passes_;
  SweepCounts counts_;
  Fragments<Index, Normal> fragments_;
  Delivery<Index, Normal> delivery_;
};

template <class Index, class Normal>
template <class Normals>
bool Sweep<Index, Normal>::sweep(const SweptRow& row, const Normals& normals, const Sink& sink,
                                 Statistics& statistics) {
  if (!delivery_.settle(fragments_, sink, statistics)) return false;
  do {
    while (passes_.has_next()) {
      const Pass& pass = passes_.pass();
      const Vertex& vertex = passes_.vertex();
      passes_.advance();
      if (row.work == RowWork::take_passes)
        fragments_.take(pass, vertex, normals);
      else if (row.work == RowWork::end_chains)
        fragments_.end_at(pass, vertex);
      else
        fragments_.begin_below(pass, vertex);
      if (fragments_.has_outgoing() && !delivery_.settle(fragments_, sink, statistics))
        return false;
    }
  } while (passes_.find(row, counts_));
  counts_.add_to(statistics);
  return true;
}

}  // namespace discmc::trace

#endif
