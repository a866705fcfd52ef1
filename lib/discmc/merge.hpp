// The merge: patches of one cell after another become regions with closed rings.
//
// Where a link's twin waits with the same incidence the two boundaries are spliced; otherwise the
// link is boundary on both sides; a link ahead is left open for the neighbour to come. The paper
// keeps all facets in hash tables and merges at the end (Montani et al. 1994, figure 5); here
// memory follows the length of the frontier.
//
// A fragment's turn is the sum of the turns from the edge before it to the edge after it, both ends
// included, modulo 256. Splicing two edges joins interior angles, so turns add up, less half a
// turn: a closed ring that has turned once counter-clockwise is outer, once clockwise a hole.
#ifndef DISCMC_MERGE_HPP
#define DISCMC_MERGE_HPP

#include <discmc/fragment_store.hpp>
#include <discmc/gradient_normals.hpp>
#include <discmc/limits.hpp>
#include <discmc/patch_table.hpp>
#include <discmc/regions.hpp>
#include <discmc/sink.hpp>

namespace discmc {

/// What a cell is made of: facets, and what classic Marching Cubes would make instead.
struct CellCounts {
  uint32_t facets;
  uint32_t classic_triangles;
};

/// High-water marks of the pools, in records.
struct HighWater {
  uint32_t edges, runs, rings, regions, slots;
};

/// Index as in Extractor; Normals is what it makes of them.
template <class Index, class Normals = NoNormals>
class Merge {
 public:
  Normals& normals() { return fragments_.normals(); }
  const Normals& normals() const { return fragments_.normals(); }

  /// Lays the pools out in the arena and writes nothing there; call clear() when it had room.
  void start(Arena& arena, const Limits& limits, const Capacities& capacities,
             const PatchTable* table, bool spills);
  void clear();

  /// Takes a cell's patches in and counts. Limit: settled(). Cost: bounded by the cell's links.
  CellCounts take_cell(const Cell& cell);

  /// Whether the next cell may be taken: no region waits for the sink, and runs are not short.
  bool settled() const { return !is_delivering_ && !regions_.has_complete() && !runs_are_short(); }

  /// Delivers what is complete, and spills when runs are short. Then the next cell may be taken.
  /// False when the sink said "not now": call again.
  bool settle(const Sink& sink, Statistics& statistics);

  uint64_t cuts() const { return cuts_; }
  HighWater high_water() const;

 private:
  using Normal = typename Normals::Normal;
  struct Walk;

  void take_patch(const Cell& cell, const Patch& patch, const Index (&behind)[behind_places]);
  void meet_twins(Walk& walk, const Index (&behind)[behind_places]);
  void begin_walk(Walk& walk);
  void walk_link(Walk& walk, int i);
  bool may_splice(Walk& walk, int i);
  void splice(Walk& walk, int i);
  void finish_walk(Walk& walk);

  Index open_edge(const Walk& walk, Place place);
  Index new_edge(Index region);
  void make_boundary(const Walk& walk, int i, Index edge, Direction direction);
  void meet_at(const Walk& walk, int i);
  void append(Index edge, Direction direction);
  void join(Index edge, Index other);
  void touch(Index index, const Fragment<Index, Normal>& fragment, Index region, uint8_t kind);
  void close_ring(const Walk& walk, int i, Index edge);
  void remove(Index edge);
  void link(Index edge, Index next);
  void turn_by(Index edge, int turn) { turns_[edge] = static_cast<uint8_t>(turns_[edge] + turn); }

  bool runs_are_short() const { return spills_ && fragments_.available() < runs_kept_; }
  bool begin_delivery();
  bool should_spill(const Fragment<Index, Normal>& fragment) const;
  void go_on(Run run, Statistics& statistics);
  void end_runs(Statistics& statistics);

  // Small members stand first, where they are reached by short instructions.
  bool spills_ = false;
  bool boundary_only_ = false;  // this cell opens and splices nothing

  // The region or fragment that is being delivered: the next event, and what it tells of.
  bool is_delivering_ = false;
  Event::Kind next_event_ = Event::Kind::region;
  Incidence incidence_ = 0;
  Index ring_ = no_record;  // of the region; no_record for a fragment
  Index last_ring_ = no_record;
  Index node_ = no_record;  // of the next run; no_record for the one in place
  Fragment<Index, Normal>* fragment_ = nullptr;
  uint32_t next_fragment_ = 0;

  uint32_t halo_ = 0;
  const PatchTable* table_ = nullptr;
  uint8_t* turns_ = nullptr;  // by edge
  Pool<Edge<Index, Normal>, Index> edges_;
  FragmentStore<Index, Normals> fragments_;
  Regions<Index, Normal> regions_;
  Frontier<Index> frontier_;

  uint32_t splits_ = 0;            // boundaries that will each need one more ring record
  uint32_t edges_kept_short_ = 0;  // of the pool, for edges that do not wait a whole layer
  uint32_t runs_kept_ = 0;         // of the pool: with fewer available, long fragments are spilled
  uint64_t cuts_ = 0;

  // The fragments that the last cell may have lengthened: the candidates for a spill.
  struct Touched {
    Index index;
    uint8_t incidence;  // and is_ring
  };
  static constexpr uint8_t is_ring = 0x80;
  uint32_t touched_count_ = 0;
  Touched touched_[CellReserve::runs + CellReserve::rings + cell_bounds.behind_links] = {};
};

#define DISCMC_DECLARE(Index)                                    \
  extern template class Merge<Index>;                            \
  extern template class Merge<Index, GradientNormals<uint8_t>>;  \
  extern template class Merge<Index, GradientNormals<uint16_t>>; \
  extern template class Merge<Index, GradientNormals<int16_t>>;

DISCMC_DECLARE(uint16_t)
DISCMC_DECLARE(uint32_t)
#undef DISCMC_DECLARE

}  // namespace discmc

#endif
