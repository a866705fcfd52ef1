// The regions of a small block straight from their definition: facets joined across shared edges.
//
// It is fast because the facets of a cell are tabulated by configuration, and because cells can be
// removed, last in first out. Blocks with the same first cells share their work. The forest uses
// the facets of cells, but no sectors, passes or queues.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <discmc/geometry/facet_table.hpp>
#include <vector>

namespace discmc::prove {

/// The facets of one configuration that hang together within the cell, as groups.
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
  FaceLink link[faces][2];  ///< by place
};

/// What is known of every configuration, and of every group in every cell of a block.
class GroupTable {
 public:
  /// `side` cells along each axis; the first of them has corner 0 at voxel `first` on each axis.
  GroupTable(int32_t side, int32_t first);

  const CellGroups& groups(Configuration configuration) const { return groups_[configuration]; }
  int32_t side() const { return side_; }
  size_t cell(int32_t x, int32_t y, int32_t z) const {
    return static_cast<size_t>((z * side_ + y) * side_ + x);
  }

  /// The hash of the links around a group. Both are in the terms of reference::fingerprint().
  uint64_t hash(size_t cell, Configuration configuration, int group) const {
    return hashes_[cell * configurations + configuration][static_cast<size_t>(group)];
  }

 private:
  int32_t side_;
  std::array<CellGroups, configurations> groups_;
  std::vector<std::array<uint64_t, CellGroups::max_groups>> hashes_;  // by cell and configuration
};

/// A union-find forest over the groups of the cells taken in, in the order x, y, z.
class Forest {
 public:
  explicit Forest(const GroupTable& table);

  /// Joins a cell's groups with those across the three faces behind it.
  void add(int32_t x, int32_t y, int32_t z, Configuration configuration);

  /// Where the forest is; going back takes out all that was taken in since.
  struct Mark {
    uint32_t nodes, unions, links;
    uint64_t fingerprint;
  };
  Mark mark() const { return {nodes_, unions_, links_, fingerprint_}; }
  void go_back(const Mark& mark);

  /// The fingerprint of reference::fingerprint_of_cells(), were the cells taken in the whole
  /// volume.
  uint64_t fingerprint() const { return fingerprint_; }
  /// The links of all boundaries.
  uint32_t links() const { return links_; }

 private:
  struct Node {
    uint32_t parent;
    Incidence incidence;
    uint64_t hash;  // of a root: of its region's boundary
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
  std::vector<uint32_t> united_;  // the roots that became children, in this order
};

}  // namespace discmc::prove
