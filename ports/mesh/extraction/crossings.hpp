// The crossings of the surface with the edges of the lattice, interpolated between the samples.
#ifndef DISCMC_MESH_EXTRACTION_CROSSINGS_HPP
#define DISCMC_MESH_EXTRACTION_CROSSINGS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <discmc/geometry/cell.hpp>

#include "samples/slice_reader.hpp"
#include "selection.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// The crossings of a volume. Memory: eight bytes for each, and for each row of an axis.
class Crossings {
 public:
  /// How near a crossing comes to a voxel. So two of them never meet there. Units: half-steps.
  static constexpr double margin = 1.0 / 64;

  /// first: where the volume begins in the coordinates of the vertices; Units: half-steps.
  Crossings(const std::array<std::uint32_t, 3>& dims, const Vertex& first)
      : dims_(dims), first_(first) {}

  /// The point of the interpolated surface that replaces a vertex of the merged one: the crossing
  /// of an edge replaces its middle, the mean of the crossings around it a centroid. If a voxel is
  /// outside the volume or its mask, or a sample is not finite, the crossing is in the middle.
  /// Units: half-steps.
  Point interpolated(const Vertex& vertex) const;

 private:
  friend class CrossingFinder;

  // On the edge that begins at voxel x of its row.
  struct Crossing {
    std::uint16_t x;
    bool falls;  // begins on, and ends off
    float at;    // from the voxel; Units: half-steps
  };
  // Row i, of all slices, has crossings[begin[i]] to crossings[begin[i + 1]].
  struct Rows {
    std::vector<std::size_t> begin{0};
    std::vector<Crossing> crossings;
  };

  Point in_volume(const Vertex& vertex) const;
  bool is_inside(const Vertex& voxel) const;
  const Crossing* crossing_of(const Vertex& middle) const;
  Point on_edge(const Vertex& middle) const;
  Configuration configuration_around(const Vertex& centroid) const;

  std::array<std::uint32_t, 3> dims_;
  Vertex first_;
  std::array<Rows, 3> along_;
};

/// Finds the crossings, slice by slice. Holds one slice.
class CrossingFinder {
 public:
  /// first: as Crossings.
  CrossingFinder(const SampleGrid& info, const Selection& selection,
                 const Vertex& first = {0, 0, 0});
  CrossingFinder(CrossingFinder&&) noexcept;
  CrossingFinder& operator=(CrossingFinder&&) noexcept;
  ~CrossingFinder();

  /// Takes the next slice, as SliceReader::read_slice() gives it. mask: rows of bits, if there are
  /// any: what is off there is off. Beside it the crossing is in the middle, where the samples
  /// cross nothing.
  void add_slice(const void* samples, const std::uint8_t* mask = nullptr);

  /// What was found, after the last slice. Owner: the finder.
  const Crossings& crossings() const;

 private:
  class Slices;
  template <class Sample>
  class SlicesOf;
  std::unique_ptr<Slices> slices_;
};

}  // namespace discmc::meshing

#endif
