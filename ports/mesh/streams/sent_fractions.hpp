// Where a stream of slices has the surface on the edges between voxels.
#ifndef DISCMC_MESH_STREAMS_SENT_FRACTIONS_HPP
#define DISCMC_MESH_STREAMS_SENT_FRACTIONS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

#include "extraction/crossings.hpp"

namespace discmc::meshing {

/// The fractions of a scan. Memory: four bytes for each voxel that has any, and 16 for each row.
class SentFractions {
 public:
  /// Keeps those of an event; any event is accepted.
  void accept(const Event& event);

  /// Whether the stream has any. Limit: after its header.
  bool are_sent() const { return levels_ > 0; }

  /// Moves crossings of the polygons to where the stream has them.
  void place(Crossings& crossings) const;

 private:
  struct Row {
    std::uint32_t slice, row;
    std::size_t begin;  // in voxels_
  };
  struct Voxel {
    std::uint16_t x, entry;
  };

  std::uint16_t width_ = 0;
  std::uint8_t levels_ = 0;
  std::vector<Row> rows_;
  std::vector<Voxel> voxels_;
};

}  // namespace discmc::meshing

#endif
