// The sweep of a host: faster, and with the same events, while there is memory to spare.
//
// Then fragments are lists of corners (corners.hpp). When too many slots would be in use they are
// handed over to the sweep that firmware has, which goes on.
#ifndef DISCMC_HOST_CORNER_SWEEP_HPP
#define DISCMC_HOST_CORNER_SWEEP_HPP

#include <discmc/host/corners.hpp>
#include <discmc/trace/sweep.hpp>

namespace discmc::trace {

/// To an extractor what a Sweep is.
class CornerSweep : private Sweep<uint32_t, NoNormal> {
 public:
  using Plain = Sweep<uint32_t, NoNormal>;

  using Plain::delivery;
  using Plain::flush;
  using Plain::fragments;
  using Plain::settle_holes;
  using Plain::start;

  void learn_in(Memory memory) { learnt_.learn_in(memory); }
  void clear();
  /// Also where what has been learnt lies.
  void forget_addresses();
  bool sweep(const SweptRow& row, const NoNormals& normals, const Sink& sink,
             Statistics& statistics);

 private:
  using Slots = Corners::Slots;

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
  bool may_have_holes(const Chain& ring) const;
  Chain chain_of(uint32_t closed);
  bool deliver(const Chain& ring, const Sink& sink, Statistics& statistics);
  void put_out(const Chain& chain);

  Slots& slots() { return fragments_.slots(); }

  bool keeps_corners_ = false;
  bool is_suspended_ = false;  // the sink has said "not now"
  Corners corners_;
  LearntPasses learnt_;
  DerivedPasses passes_beyond_;  // of the slices below and above a slab
};

}  // namespace discmc::trace

#endif
