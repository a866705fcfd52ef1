// The regions of a small block from their definition: facets joined across shared edges.
//
// The facets of a cell are tabulated by configuration, and cells are removed last in, first out.
// Blocks with the same first cells share their work. The forest uses the facets of cells, but no
// sectors, passes or queues.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <discmc/geometry/facet_table.hpp>
#include <vector>

namespace discmc::prove {

/// The groups of facets of one configuration that are connected within the cell.
struct CellGroups {
  static constexpr int max_groups = 7;

  /// A link on a face, and the group that it bounds.
  struct FaceLink {
    uint8_t place;  ///< position on the face; identifies a link equally for both cells
    uint8_t group;
  };

  uint8_t count;
  uint8_t links;  ///< around all groups
  Incidence incidence[max_groups];
  uint8_t face_links[faces];
  FaceLink link[faces][2];  ///< sorted by position
};

/// Tables of all configurations, and of the groups of every cell of a block.
class GroupTable {
 public:
  /// A cube of `side` cells. On each axis, corner 0 of its first cell is at voxel `first`.
  GroupTable(int32_t side, int32_t first);

  const CellGroups& groups(Configuration configuration) const { return groups_[configuration]; }
  int32_t side() const { return side_; }
  size_t cell(int32_t x, int32_t y, int32_t z) const {
    return static_cast<size_t>((z * side_ + y) * side_ + x);
  }

  /// The hash of the links around a group, computed like reference::fingerprint().
  uint64_t hash(size_t cell, Configuration configuration, int group) const {
    return hashes_[cell * configurations + configuration][static_cast<size_t>(group)];
  }

 private:
  int32_t side_;
  std::array<CellGroups, configurations> groups_;
  std::vector<std::array<uint64_t, CellGroups::max_groups>> hashes_;  // by cell and configuration
};

/// A union-find forest over the groups of the added cells, in the order x, y, z.
class Forest {
 public:
  explicit Forest(const GroupTable& table);

  /// Joins a cell's groups with those across the three faces towards lower coordinates.
  void add(int32_t x, int32_t y, int32_t z, Configuration configuration);

  /// The position in the forest. go_back() removes all cells added since.
  struct Mark {
    uint32_t nodes, unions, links;
    uint64_t fingerprint;
  };
  Mark mark() const { return {nodes_, unions_, links_, fingerprint_}; }
  void go_back(const Mark& mark);

  /// Returns the value of reference::fingerprint_of_cells() for a volume of the added cells.
  uint64_t fingerprint() const { return fingerprint_; }
  /// Returns the number of links of all boundaries.
  uint32_t links() const { return links_; }

 private:
  struct Node {
    uint32_t parent;
    Incidence incidence;
    uint64_t hash;  // of a root: the hash of its region's boundary
  };
  struct Placed {
    Configuration configuration;
    uint32_t first_node;
  };

  uint32_t root(uint32_t node) const {
    while (nodes_of_[node].parent != node) node = nodes_of_[node].parent;
    return node;
  }
  void join_across(Face face, const Placed& cell, const Placed& behind);
  void unite(uint32_t a, uint32_t b);

  const GroupTable& table_;
  uint32_t nodes_ = 0;
  uint32_t unions_ = 0;
  uint32_t links_ = 0;
  uint64_t fingerprint_ = 0;
  std::vector<Placed> cells_;
  std::vector<Node> nodes_of_;
  std::vector<uint32_t> united_;  // the roots that became children, in the order of joining
};

}  // namespace discmc::prove
