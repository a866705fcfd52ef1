// How large a scan may be, and how many bytes it needs: all of it known at compile time.
#ifndef DISCMC_LIMITS_HPP
#define DISCMC_LIMITS_HPP

#include <discmc/arena.hpp>
#include <discmc/frontier.hpp>

namespace discmc {

/// What lies around the volume.
enum class Border : uint8_t {
  closed,  ///< a halo of off voxels: the surface is closed; coordinates -1 to 2 * extent - 1
  open,    ///< nothing: the surface ends at the outermost voxels; coordinates 0 to 2 * extent - 2
};

/// The size of a slice. The number of slices is not limited by memory.
struct Limits {
  static constexpr uint32_t max_extent = 32766;
  static constexpr uint32_t max_slices = (uint32_t{1} << 30) - 1;

  uint32_t width;   ///< voxels a row; Limit: 1 to max_extent
  uint32_t height;  ///< rows a slice; Limit: 1 to max_extent
  Border border = Border::closed;

  constexpr bool are_valid() const {
    return width >= 1 && width <= max_extent && height >= 1 && height <= max_extent &&
           border <= Border::open;
  }
  constexpr uint32_t halo() const { return border == Border::closed ? 1 : 0; }
  /// Cells a row and rows of cells a layer. An open slice one voxel wide has none.
  constexpr uint32_t columns() const { return width + 2 * halo() - 1; }
  constexpr uint32_t cell_rows() const { return height + 2 * halo() - 1; }
  /// 32-bit words of one row of bits, halo included.
  constexpr uint32_t row_words() const { return (width + 2 * halo() + 31) / 32; }
};

/// How many records of each kind there is room for. A shortage costs merging, never correctness.
struct Capacities {
  uint32_t edges;    ///< unresolved edges; about 2 for every active cell of a layer
  uint32_t runs;     ///< runs of open boundaries beyond one an edge; a shortage spills (or cuts)
  uint32_t rings;    ///< closed rings whose region is not complete: holes; a shortage cuts
  uint32_t regions;  ///< regions not yet complete
  uint32_t slots;    ///< of the hash table; 1.25 to 2 times the edges is a good number
};

/// The reserves that let one cell of any configuration be swept without looking, and the least
/// capacities with which a scan works at all (every link is then boundary, nothing is merged).
struct CellReserve {
  // Every link appends a run; a link behind may also append two to the ring of the edge that waits
  // there; dissolving a patch's marker may append one more.
  static constexpr uint32_t runs =
      static_cast<uint32_t>(cell_bounds.links + 2 * cell_bounds.behind_links + cell_bounds.patches);
  static constexpr uint32_t regions = static_cast<uint32_t>(cell_bounds.patches);
  // Every patch, and every region behind, may be completed by the cell and then needs its last
  // ring.
  static constexpr uint32_t rings =
      static_cast<uint32_t>(cell_bounds.patches + cell_bounds.behind_links);
};

constexpr Capacities minimum_capacities() {
  return {2, CellReserve::runs, CellReserve::rings, CellReserve::regions, 1};
}

namespace sizing {

// Twice a number and some more, or the largest number below.
constexpr uint32_t twice(uint32_t number, uint32_t more) {
  return number <= (UINT32_MAX - more) / 2 ? 2 * number + more : UINT32_MAX;
}

}  // namespace sizing

/// Capacities with which no volume ever cuts a region apart, given a sink that takes fragments: two
/// edges for every cell face ahead, and a hash table with a slot for every key. Holes of a region
/// that stays open keep their ring records: beyond their number, which no capacity can bound, they
/// are joined by slits, which count as cuts and vanish when rings are made simple.
constexpr Capacities worst_case_capacities(const Limits& limits) {
  const uint32_t keys = Frontier<uint32_t>::keys(limits.columns(), limits.cell_rows());
  // The places within the slice twice: the pool keeps as many back from edges that wait above.
  const uint32_t edges = keys + 2 * (2 * limits.columns() + 4);
  return {edges, sizing::twice(edges, CellReserve::runs), edges + CellReserve::rings,
          sizing::twice(edges, CellReserve::regions), keys + (keys == 0)};
}

/// The bytes that a scan with these limits and capacities takes from the caller's memory.
template <class Index>
constexpr uint64_t bytes_for(const Limits& limits, const Capacities& capacities) {
  struct Array {
    uint32_t count;
    uint32_t record_bytes;
  };
  const Array arrays[] = {
      {limits.row_words() * (limits.height + 3), sizeof(uint32_t)},  // see BitRows
      {Frontier<Index>::row_places(limits.columns()), sizeof(Index)},
      {capacities.edges, sizeof(Edge<Index>)},
      {capacities.edges, sizeof(uint8_t)},
      {capacities.runs, sizeof(RunNode<Index>)},
      {capacities.rings, sizeof(ClosedRing<Index>)},
      {capacities.regions, sizeof(RegionNode<Index>)},
      {capacities.slots, sizeof(uint32_t)},
      {capacities.slots, sizeof(Index)},
  };
  uint64_t sum = Arena::alignment - 1;
  for (const Array& array : arrays) sum += Arena::bytes_of(array.count, array.record_bytes);
  return sum;
}

/// Whether an index of this width can count the records.
template <class Index>
constexpr bool are_valid(const Capacities& capacities) {
  constexpr uint64_t most = static_cast<Index>(~Index{0});
  constexpr Capacities least = minimum_capacities();
  if (capacities.edges < least.edges || capacities.runs < least.runs ||
      capacities.rings < least.rings || capacities.regions < least.regions ||
      capacities.slots < least.slots)
    return false;
  // A region node counts the edges and nodes that name it in one index.
  return uint64_t{capacities.edges} + capacities.regions < most && capacities.runs < most &&
         capacities.rings < most && capacities.slots <= 0x7FFFFFFF;
}

/// The least memory with which a scan works: every surface comes out right, not merged beyond
/// cells.
template <class Index>
constexpr uint64_t minimum_bytes(const Limits& limits) {
  return bytes_for<Index>(limits, minimum_capacities());
}

/// The memory with which no volume ever cuts a region apart (see worst_case_capacities()).
/// Only with those capacities: the default split of as many bytes has fewer rings and regions. Far
/// more than real volumes need: see default_capacities(). Limit: the capacities are valid, which
/// those of slices near the greatest extents are not.
template <class Index>
constexpr uint64_t worst_case_bytes(const Limits& limits) {
  return bytes_for<Index>(limits, worst_case_capacities(limits));
}

/// The default split of a number of bytes: for every 16 edges 20 runs, 10 regions, 1 ring and 20
/// slots. All integers, the same on every machine. Bytes below minimum_bytes() give the minimum.
template <class Index>
constexpr Capacities default_capacities(const Limits& limits, uint64_t bytes) {
  const Capacities least = minimum_capacities();
  const Capacities most = worst_case_capacities(limits);
  constexpr uint32_t unit = 16 * (sizeof(Edge<Index>) + 1) + 20 * sizeof(RunNode<Index>) +
                            10 * sizeof(RegionNode<Index>) + sizeof(ClosedRing<Index>) +
                            20 * (sizeof(uint32_t) + sizeof(Index));
  // Seven arrays lose at most three bytes each to alignment.
  const uint64_t taken = minimum_bytes<Index>(limits) + 7 * Arena::alignment;
  // In 32 bits: no 64-bit division on small machines, and more than 4 GiB would be of no use.
  constexpr uint32_t countable = (static_cast<Index>(~Index{0}) - 64U) / 26;
  const uint64_t spare = bytes > taken ? bytes - taken : 0;
  const uint32_t affordable = static_cast<uint32_t>(spare < UINT32_MAX ? spare : UINT32_MAX) / unit;
  const uint32_t units = affordable < countable ? affordable : countable;
  const auto at_most = [](uint32_t value, uint32_t limit) { return value < limit ? value : limit; };
  return {at_most(least.edges + 16 * units, most.edges), least.runs + 20 * units,
          at_most(least.rings + units, most.rings),
          at_most(least.regions + 10 * units, most.regions),
          at_most(least.slots + 20 * units, most.slots)};
}

}  // namespace discmc

#endif
