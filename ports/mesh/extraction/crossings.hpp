// The crossings of the surface with the lattice edges, interpolated between samples.
#ifndef DISCMC_MESH_EXTRACTION_CROSSINGS_HPP
#define DISCMC_MESH_EXTRACTION_CROSSINGS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <discmc/geometry/cell.hpp>

#include "samples/slice_reader.hpp"
#include "selection.hpp"
#include "surface/point.hpp"
#include "surface/polygons.hpp"

namespace discmc::meshing {

/// Whether a point of the lattice is the middle of an edge between voxels.
constexpr bool is_middle(const Vertex& vertex) {
  return (vertex.x & 1) + (vertex.y & 1) + (vertex.z & 1) == 1;
}

/// The crossings of a volume. Memory: eight bytes per crossing, and per row of an axis; eight more
/// per crossing with ends.
class Crossings {
 public:
  /// The samples of both voxels of an edge, minus the level.
  struct Ends {
    float begin, end;
  };
  /// Identifies a crossing by its axis and its index in the order of the edges.
  struct Id {
    std::uint8_t axis;
    std::uint32_t number;
  };
  /// The least distance of a crossing from a voxel, which keeps two crossings apart. Units:
  /// half-steps.
  static constexpr double margin = 1.0 / 64;

  /// first: the origin of the volume in the vertices' coordinates; Units: half-steps.
  Crossings(const std::array<std::uint32_t, 3>& dims, const Vertex& first)
      : dims_(dims), first_(first) {}
  /// Finds the crossings of polygons, at the middles of edges; none on edges that end outside the
  /// volume. Throws std::length_error if the polygons span more than 2^26 rows of voxels, or cross
  /// more than 2^27 edges.
  Crossings(const std::array<std::uint32_t, 3>& dims, const Polygons& polygons);

  /// Returns the point of the interpolated surface that replaces a vertex of the merged one. The
  /// crossing of an edge replaces its middle; the mean of the crossings around a centroid replaces
  /// the centroid. A crossing is in the middle if a voxel is outside the volume or its mask, or if
  /// a sample is not finite. Units: half-steps.
  Point interpolated(const Vertex& vertex) const;
  /// Likewise for the middle of an edge along an axis. at: from at() of its crossing.
  static Point interpolated(const Vertex& middle, std::size_t axis, float at) {
    const double moved = static_cast<double>(at) - 1;
    return {middle.x + (axis == 0 ? moved : 0), middle.y + (axis == 1 ? moved : 0),
            middle.z + (axis == 2 ? moved : 0)};
  }

  /// Returns the crossing at the middle of an edge, if there is one. Limit: is_middle().
  std::optional<Id> find(const Vertex& middle) const;
  /// Calls `call` with the crossing at the middle of an edge, or with the crossings around a
  /// centroid.
  template <class Call>
  void for_each_near(const Vertex& vertex, Call call) const {
    const auto call_if_found = [&](const Vertex& middle) {
      if (const auto id = find(middle)) call(*id);
    };
    if (is_middle(vertex)) return call_if_found(vertex);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int a : {-1, 1})
        for (const int b : {-1, 1}) {
          std::array<std::int32_t, 3> at = {vertex.x, vertex.y, vertex.z};
          at[(axis + 1) % 3] += a;
          at[(axis + 2) % 3] += b;
          call_if_found({at[0], at[1], at[2]});
        }
  }
  /// Returns the number of crossings along an axis.
  std::size_t count(std::size_t axis) const { return along_[axis].crossings.size(); }
  /// Whether the edge begins on and ends off.
  bool falls(Id id) const { return along_[id.axis].crossings[id.number].falls; }
  /// Calls `call` with each crossing, and with the middle of its edge.
  template <class Call>
  void for_each(Call call) const {
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      const Rows& rows = along_[axis];
      for (std::size_t row = 0; row + 1 < rows.begin.size(); ++row)
        for (std::size_t i = rows.begin[row]; i < rows.begin[row + 1]; ++i)
          call(Id{axis, static_cast<std::uint32_t>(i)}, middle_of(axis, row, rows.crossings[i].x));
    }
  }
  /// Returns the position of the crossing from the voxel at which its edge begins. Units:
  /// half-steps.
  float at(Id id) const { return along_[id.axis].crossings[id.number].at; }
  /// Returns the number of intervals of the edge. The crossing is in the middle of its interval.
  std::uint8_t intervals(Id id) const { return along_[id.axis].crossings[id.number].intervals; }
  /// Limit: from `margin` to 2 - `margin`.
  void move(Id id, float at) { along_[id.axis].crossings[id.number].at = at; }
  void move(Id id, float at, std::uint8_t intervals) {
    along_[id.axis].crossings[id.number].intervals = intervals;
    move(id, at);
  }

  /// Limit: the finder keeps ends.
  Ends& ends(Id id) { return along_[id.axis].ends[id.number]; }
  /// Returns the crossing, as at(), of the line between two ends with zero. Limit: their signs
  /// differ.
  static float zero_between(Ends ends) { return 2 * (ends.begin / (ends.begin - ends.end)); }

 private:
  friend class CrossingFinder;

  // A crossing on the edge that begins at voxel x of its row.
  struct Crossing {
    std::uint16_t x;
    bool falls;  // whether the edge begins on and ends off
    std::uint8_t intervals;
    float at;  // from the voxel; Units: half-steps
  };
  // Row i, counted over all slices, has crossings[begin[i]] to crossings[begin[i + 1]].
  struct Rows {
    std::vector<std::size_t> begin{0};
    std::vector<Crossing> crossings;
    std::vector<Ends> ends{};  // one per crossing, or empty
  };

  class PolygonFinder;

  Vertex middle_of(std::size_t axis, std::size_t row, std::uint32_t x) const;
  Point in_volume(const Vertex& vertex) const;
  bool is_inside(const Vertex& voxel) const;
  const Crossing* crossing_of(const Vertex& middle) const;
  Point on_edge(const Vertex& middle) const;
  Configuration configuration_around(const Vertex& centroid) const;

  std::array<std::uint32_t, 3> dims_;
  Vertex first_;
  std::array<Rows, 3> along_;
};

/// Finds the crossings slice by slice. Memory: one slice.
class CrossingFinder {
 public:
  /// first: as for Crossings. keeps_ends: for Crossings::ends().
  CrossingFinder(const SampleGrid& info, const Selection& selection,
                 const Vertex& first = {0, 0, 0}, bool keeps_ends = false);
  CrossingFinder(CrossingFinder&&) noexcept;
  CrossingFinder& operator=(CrossingFinder&&) noexcept;
  ~CrossingFinder();

  /// Adds the next slice from SliceReader::read_slice(). mask: rows of bits, or null; voxels that
  /// are off there are off. Beside the mask, crossings are in the middle, because the samples cross
  /// nothing.
  void add_slice(const void* samples, const std::uint8_t* mask = nullptr);

  /// Returns the crossings, after the last slice. Owner: the finder.
  const Crossings& crossings() const;
  Crossings& crossings();

 private:
  class Slices;
  template <class Sample>
  class TypedSlices;
  std::unique_ptr<Slices> slices_;
};

}  // namespace discmc::meshing

#endif
