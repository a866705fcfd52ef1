// The slots of the pool: waiting ends, runs of fragments, and holes.
//
// A fragment is a piece of a chain whose two ends wait for later vertices. The chain leaves the
// fragment at its tail and arrives at its begin. The side in progress at either end has no length
// yet. The end holds its direction, and the place at which it starts (tail) or stops (begin). The
// sides between are runs, in a circular list of slots. The tail holds the last slot of the list, or
// the begin does if the tail is loose. A fragment of k corners therefore has k - 1 runs.
#ifndef DISCMC_TRACE_SLOTS_HPP
#define DISCMC_TRACE_SLOTS_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/chain.hpp>
#include <discmc/trace/intake.hpp>

namespace discmc::detail::trace {

/// A normal, or nothing in an extractor without normals.
template <class Normal>
struct NormalPart {
  Normal normal_;
  Normal normal() const { return normal_; }
  void set_normal(Normal normal) { normal_ = normal; }
};
template <>
struct NormalPart<NoNormal> {
  NoNormal normal() const { return {}; }
  void set_normal(NoNormal) {}
};

/// The position of a vertex along any line of links, as one number: 3 x + 2 y + z modulo 8,192.
/// Every link changes it by 1 to 6. Links along z change it by 2, because sides may be longest
/// along z.
using Place = uint32_t;

constexpr uint32_t place_bits = 13;
constexpr Place place_of(const Vertex& v) {
  return (3 * static_cast<uint32_t>(v.x) + 2 * static_cast<uint32_t>(v.y) +
          static_cast<uint32_t>(v.z)) &
         ((1U << place_bits) - 1);
}

/// A direction, and the place of a corner on the line along it.
class Side {
 public:
  Side() = default;
  Side(Direction direction, Place place) : code_(static_cast<uint16_t>(place << 3 | direction)) {}
  Direction direction() const { return code_ & 7; }
  Place place() const { return code_ >> 3; }

  uint16_t bits() const { return code_; }
  void set_bits(uint16_t bits) { code_ = bits; }

 private:
  uint16_t code_;
};

/// A complete straight side in two bytes: direction, and 1 to max_short_length links. 0: none.
using ShortRun = uint16_t;
constexpr uint32_t max_short_length = 8191;

constexpr ShortRun short_run(Direction direction, uint32_t length) {
  return static_cast<ShortRun>(length << 3 | direction);
}
constexpr Direction direction_of(ShortRun run) {
  return run & 7;
}
constexpr uint32_t length_of(ShortRun run) {
  return uint32_t{run} >> 3;
}
constexpr Run long_run(ShortRun run) {
  return Run::from_code(run);
}

/// The mate of an end whose other end is loose. The lowest bits of a begin hold the direction of
/// the previous link.
template <class Index>
constexpr Index loose_end(Direction incoming = 0) {
  return static_cast<Index>(static_cast<Index>(~Index{7}) | incoming);
}
template <class Index>
constexpr bool is_loose(Index mate) {
  return mate >= loose_end<Index>();
}

/// Every slot begins with the next slot of its list, or of the free list of the pool.
template <class Index>
struct Linked {
  Index next;
};

/// A waiting end. If the mate is no_slot, the slot is a count of lost ends (queues.hpp).
template <class Index, class Normal>
struct End : Linked<Index>, NormalPart<Normal> {  // of a tail: the normal at the start of its side
  Side side;
  Index mate;  // the fragment's other end, or is_loose()
  Index runs;  // the run list of the fragment
};

/// Up to three runs of a fragment, in order. Unused runs are 0, before or after the others.
template <class Index, class Normal>
struct RunSlot : Linked<Index> {
  static constexpr int entries = 3;
  struct Entry : NormalPart<Normal> {
    ShortRun run;
  };
  Entry entry[entries];
};

/// A hole that waits for the ring around it, in two slots.
template <class Index>
struct Hole : Linked<Index> {
  Index runs;   // its run list
  Index start;  // index of the other slot
  Incidence incidence;
  uint8_t is_marked;  // whether it is delivered next
};
template <class Index>
struct HoleStart {
  uint16_t x, y;  // plus one, because coordinates in a slice are -1 to 65,531
  uint16_t z[2];  // lower and upper half

  void set(const Vertex& v) {
    x = static_cast<uint16_t>(v.x + 1);
    y = static_cast<uint16_t>(v.y + 1);
    z[0] = static_cast<uint16_t>(v.z);
    z[1] = static_cast<uint16_t>(static_cast<uint32_t>(v.z) >> 16);
  }
  Vertex get() const { return {x - 1, y - 1, static_cast<int32_t>(z[0] | uint32_t{z[1]} << 16)}; }
};

/// With 32-bit indices: a node of a tree, with a note of a side before it (RingTree).
template <>
struct Hole<uint32_t> {
  uint32_t number;  // order in which holes closed, modulo 2^32
  uint32_t runs;    // its run list
  uint32_t start;   // index of the other slot
  uint32_t bits;    // 0-4 incidence, 5-7 first direction, 8 noted, 9 leads inside, 10-31 crossing

  void set(Incidence incidence, Direction first) { bits = uint32_t{first} << 5 | incidence; }
  Incidence incidence() const { return bits & 31; }
  Direction first() const { return bits >> 5 & 7; }

  bool is_noted() const { return (bits >> 8 & 1) != 0; }
  bool leads_inside() const { return (bits >> 9 & 1) != 0; }
  int32_t crossing() const { return static_cast<int32_t>(bits) >> 10; }
  void set_note(int64_t crossing, bool leads_inside) {
    bits = static_cast<uint32_t>(crossing) << 10 | (leads_inside ? 3U : 1U) << 8 | (bits & 255);
  }
  void clear_note() { bits &= 255; }
};
template <>
struct HoleStart<uint32_t> {
  uint16_t x, y;  // plus one
  int32_t z;
  uint32_t left, right;  // in the tree

  void set(const Vertex& v) {
    x = static_cast<uint16_t>(v.x + 1);
    y = static_cast<uint16_t>(v.y + 1);
    z = v.z;
  }
  Vertex get() const { return {x - 1, y - 1, z}; }
};

template <class Index, class Normal>
union Slot {
  Linked<Index> linked;
  End<Index, Normal> end;
  RunSlot<Index, Normal> runs;
  Hole<Index> hole;
  HoleStart<Index> hole_start;
};

}  // namespace discmc::detail::trace

#endif
