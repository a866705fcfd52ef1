// The frontier: what a sweep remembers between a cell and the neighbours it has yet to visit.
//
// An unresolved edge is a link on a face ahead, waiting for the cell on the other side. Open
// boundaries are circular lists of unresolved edges with a chain fragment after each. Edges towards
// the next cell and the next row have places of their own; those towards the next slice live in a
// hash table. A look-up that finds nothing means that the edge was cut when it was born.
#ifndef DISCMC_FRONTIER_HPP
#define DISCMC_FRONTIER_HPP

#include <discmc/chain.hpp>
#include <discmc/hash_table.hpp>
#include <discmc/normal.hpp>
#include <discmc/patch_table.hpp>
#include <discmc/pool.hpp>

namespace discmc {

/// What a run carries of the normal where it starts when nobody wants normals.
struct NoNormal {};

/// The normal where a run starts, or nothing. There is none as long as the link before it is
/// unresolved. Normal is OctahedralNormal or NoNormal.
template <class Normal>
struct StartNormal {
  Normal normal_at_start;

  Normal start_normal() const { return normal_at_start; }
  void set_start_normal(Normal normal) { normal_at_start = normal; }
};
template <>
struct StartNormal<NoNormal> {
  NoNormal start_normal() const { return {}; }
  void set_start_normal(NoNormal) {}
};

/// A run of a fragment in the arena. The run is kept in halves so that the record packs to 6 bytes
/// with 16-bit indices.
template <class Index, class Normal = NoNormal>
struct RunNode : StartNormal<Normal> {
  Index next;
  uint16_t low, high;

  void set(Run run) {
    low = static_cast<uint16_t>(run.code() & 0xFFFF);
    high = static_cast<uint16_t>(run.code() >> 16);
  }
  Run run() const { return Run::from_code(uint32_t{high} << 16 | low); }
};

/// A chain fragment: a circular list of nodes, named by its last one, and one more run in place.
/// The run in place is what makes a spill possible when the pool of runs is empty.
template <class Index, class Normal = NoNormal>
struct Fragment : StartNormal<Normal> {  ///< of the run in place
  Index next;                            ///< of the record that holds the fragment
  Index last;
  Run tail;

  void clear() {
    tail = Run();
    last = no_record;
    this->set_start_normal({});
  }
  void move_from(const Fragment& other) {
    tail = other.tail;
    last = other.last;
    this->set_start_normal(other.start_normal());
  }
  bool is_empty() const { return tail.is_empty(); }
};

/// An unresolved edge. Its boundary goes on with the fragment and then with the edge `next`.
template <class Index, class Normal = NoNormal>
struct Edge : Fragment<Index, Normal> {
  Index previous;
  Index region;
};

/// A closed ring that waits for its region to be complete; `next` in the circular list of its
/// rings.
template <class Index, class Normal = NoNormal>
struct ClosedRing : Fragment<Index, Normal> {
  int32_t z;
  uint16_t x, y;  ///< one more than the coordinate, which may be -1
  uint8_t hole;
};

/// A node of the union-find forest of regions. A root's `parent` is itself. `references` counts the
/// unresolved edges and the nodes that name this one: a root that nobody names is complete.
template <class Index>
struct RegionNode {
  union {
    Index parent;
    Index next;  ///< in the queue of complete regions
  };
  Index rings;  ///< the last of the root's circular list of closed rings
  Index references;
  Incidence incidence;
  uint8_t rank;
};

static_assert(sizeof(RunNode<uint16_t>) == 6 && sizeof(RunNode<uint32_t>) == 8 &&
                  sizeof(RunNode<uint16_t, OctahedralNormal>) == 8,
              "no padding");
static_assert(sizeof(Edge<uint16_t>) == 12 && sizeof(Edge<uint32_t>) == 20, "no padding");
static_assert(sizeof(ClosedRing<uint16_t>) == 20 && sizeof(ClosedRing<uint32_t>) == 24,
              "as laid out");
static_assert(sizeof(RegionNode<uint16_t>) == 8 && sizeof(RegionNode<uint32_t>) == 16,
              "as laid out");

/// A cell as the sweep meets it.
struct Cell {
  uint32_t column, row;
  int32_t z;   ///< of corner 0; Units: half-steps
  bool seals;  ///< above the last slice of an open volume: what waits below becomes boundary
  Configuration configuration;
};

/// The edges that wait for a neighbour, by place.
template <class Index>
class Frontier {
 public:
  void start(Index* row_places, uint32_t columns, uint32_t rows) {
    waiting_back_ = row_places;
    columns_ = columns;
    rows_ = rows;
  }

  HashTable<Index>& table() { return table_; }
  const HashTable<Index>& table() const { return table_; }

  /// The indices that the places towards the next row take.
  static constexpr uint32_t row_places(uint32_t columns) { return 2 * columns; }
  /// The range of the hash table's keys: two links on the upper face of every cell of a layer.
  static constexpr uint32_t keys(uint32_t columns, uint32_t rows) { return 2 * columns * rows; }

  /// The edges that wait on the faces behind a cell, by place. Only the places that the cell's
  /// patches use have a meaning. `below` tells which of the links on face_below exist.
  void gather(const Cell& cell, uint8_t below, Index (&behind)[behind_places]) {
    const bool has_left = cell.column > 0 && !cell.seals;
    const bool has_front = cell.row > 0 && !cell.seals;
    const Index* const front = waiting_back_ + 2 * cell.column;
    const uint32_t key = key_of(cell);
    for (uint32_t slot = 0; slot < 2; ++slot) {
      behind[slot] = has_left ? waiting_right_[slot] : Index{no_record};
      behind[2 + slot] = has_front ? front[slot] : Index{no_record};
      behind[4 + slot] = below >> slot & 1 ? table_.take(key + slot) : Index{no_record};
    }
  }

  /// Whether no cell follows beyond the right or back face of this one: links there are boundary.
  bool is_border(Place place, const Cell& cell) const {
    return place / 2 == face_right ? cell.column + 1 == columns_
                                   : place / 2 == face_back && cell.row + 1 == rows_;
  }

  /// The edge that waits on the right or back face of a cell: no_record for one that was cut.
  Index& in_slice(Place place, uint32_t column) {
    Index* const waiting = place / 2 == face_right ? waiting_right_ : waiting_back_ + 2 * column;
    return waiting[place & 1];
  }

  /// Lets an edge wait on the upper face for the next layer; false when the table has no room.
  bool wait_above(Place place, const Cell& cell, Index edge) {
    return table_.insert(key_of(cell) + (place & 1), edge);
  }

 private:
  uint32_t key_of(const Cell& cell) const { return 2 * (cell.row * columns_ + cell.column); }

  HashTable<Index> table_;
  Index* waiting_back_ = nullptr;
  Index waiting_right_[2] = {};
  uint32_t columns_ = 0;
  uint32_t rows_ = 0;
};

}  // namespace discmc

#endif
