// Stores where the surface of a stream of slices crosses the edges between voxels.
#ifndef DISCMC_MESH_STREAMS_SENT_FRACTIONS_HPP
#define DISCMC_MESH_STREAMS_SENT_FRACTIONS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

#include "extraction/crossings.hpp"

namespace discmc::meshing {

/// The fractions of a scan. Memory: four bytes per voxel with fractions, and 16 per row.
class SentFractions {
 public:
  /// Stores the fractions of an event. Accepts any event.
  void accept(const Event& event);

  /// Whether the stream has fractions. Limit: after its header.
  bool are_sent() const { return levels_ > 0; }

  /// Moves crossings of the polygons to the sent fractions.
  void place(Crossings& crossings) const;

 private:
  struct Row {
    std::uint32_t slice, row;
    std::size_t begin;  // index in voxels_
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
