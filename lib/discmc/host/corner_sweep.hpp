// The sweep of a host: faster, and with the same events, while there is memory to spare.
//
// Then fragments are lists of corners (corners.hpp). When too many records would be in use they are
// handed over to the sweep that firmware has, which goes on.
#ifndef DISCMC_TRACE_CORNER_SWEEP_HPP
#define DISCMC_TRACE_CORNER_SWEEP_HPP

#include <discmc/host/corners.hpp>
#include <discmc/trace/sweep.hpp>

namespace discmc::trace {

/// To an extractor what a Sweep is.
class CornerSweep {
 public:
  static constexpr bool opens_seams = true;

  Corners::Chains& fragments() { return plain_.fragments(); }
  Delivery<uint32_t, NoNormal>& delivery() { return plain_.delivery(); }
  const Corners::Chains& fragments() const { return plain_.fragments(); }
  const Delivery<uint32_t, NoNormal>& delivery() const { return plain_.delivery(); }

  void learn_in(Memory memory) { passes_.learn_in(memory); }
  void clear();
  void forget();
  bool sweep(const SweptRow& row, const NoNormals& normals, const Sink& sink,
             Statistics& statistics);
  bool settle_holes(const Sink& sink, Statistics& statistics) {
    return plain_.settle_holes(sink, statistics);
  }

 private:
  using Records = Corners::Records;

  // A chain that is closed, or cut off at seams.
  struct Chain {
    uint32_t start;
    uint32_t corners;
    CornerCode code;  // of the start
  };

  void open_seam(const SweptRow& row);
  bool close_seam(const SweptRow& row, const Sink& sink, Statistics& statistics);
  bool sweep_corners(const SweptRow& row, const Sink& sink, Statistics& statistics);
  void hand_over(const SweptRow& row, uint32_t word);
  bool go_on_delivering(const Sink& sink, Statistics& statistics);
  bool deliver_chains(const Sink& sink, Statistics& statistics);
  Chain chain_of(uint32_t closed) const;
  bool deliver(const Chain& ring, const Sink& sink, Statistics& statistics);
  void put_out(const Chain& chain);

  Sweep<uint32_t, NoNormal> plain_;
  bool keeps_corners_ = false;
  bool is_suspended_ = false;  // the sink has said "not now"
  Corners corners_;
  LearntPasses passes_;
  DerivedPasses passes_beyond_;  // of the slices below and above a slab
};

}  // namespace discmc::trace

#endif
