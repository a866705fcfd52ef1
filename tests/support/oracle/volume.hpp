// Volumes of on and off voxels, and the basic shapes of the tests.
//
// All values are integers, so that a volume is equal on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <discmc/geometry/cell.hpp>
#include <vector>

namespace discmc::reference {

/// Returns the next number of a portable generator: splitmix64 (Steele, Lea, Flood 2014).
inline uint64_t next_random(uint64_t& state) {
  state += 0x9E3779B97F4A7C15;
  const uint64_t mixed = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
  const uint64_t twice = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
  return twice ^ (twice >> 31);
}

/// Units: voxels.
struct Size {
  uint32_t width, height, depth;
};

/// A whole volume in memory. Voxels outside it are off.
struct BitVolume {
  uint32_t width, height, depth;
  std::vector<uint8_t> on;  ///< 0 or 1 per voxel; x runs fastest, then y, then z

  explicit BitVolume(Size size)
      : width(size.width), height(size.height), depth(size.depth), on(voxels()) {}

  size_t voxels() const { return size_t{width} * height * depth; }
  size_t index(int64_t x, int64_t y, int64_t z) const {
    const auto row = static_cast<size_t>(z) * height + static_cast<size_t>(y);
    return row * width + static_cast<size_t>(x);
  }
  bool contains(int64_t x, int64_t y, int64_t z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < width && y < height && z < depth;
  }
  bool at(int64_t x, int64_t y, int64_t z) const {
    return contains(x, y, z) && on[index(x, y, z)] != 0;
  }

  /// The configuration of the cell whose corner 0 is the voxel `cell`. Units: cells.
  Configuration configuration(Vertex cell) const {
    unsigned bits = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const bool is_on =
          at(cell.x + (corner & 1), cell.y + (corner >> 1 & 1), cell.z + (corner >> 2));
      bits |= static_cast<unsigned>(is_on) << corner;
    }
    return static_cast<Configuration>(bits);
  }
};

/// Turns voxels on if on(x, y, z). Calls `on` in the order of storage.
template <class On>
BitVolume volume_of(Size size, On on) {
  BitVolume volume(size);
  auto voxel = volume.on.begin();
  for (uint32_t z = 0; z < size.depth; ++z)
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x) *voxel++ = on(x, y, z) ? 1 : 0;
  return volume;
}

/// Calls visit(cell, configuration) for every cell in the order of a sweep. If `closed` adds a halo
/// of off voxels, cells range from -1 to the last voxel; otherwise only cells with eight voxels.
template <typename Visit>
void for_each_cell(const BitVolume& volume, bool is_closed, Visit visit) {
  const int32_t first = is_closed ? -1 : 0;
  const auto end = [&](uint32_t voxels) {
    return static_cast<int32_t>(voxels) - (is_closed ? 0 : 1);
  };
  for (int32_t z = first; z < end(volume.depth); ++z)
    for (int32_t y = first; y < end(volume.height); ++y)
      for (int32_t x = first; x < end(volume.width); ++x) {
        const Vertex cell{x, y, z};
        visit(cell, volume.configuration(cell));
      }
}

/// Voxels are on if the squared distance from the centre is at most `radius_squared`. Units: the
/// centre in half-steps, so that it may lie between voxels; the radius in voxels.
BitVolume ball(Size size, Vertex centre, int64_t radius_squared);

/// Voxels from `first` to `last` are on, both included. Units: voxels.
BitVolume box(Size size, Vertex first, Vertex last);

/// A ring about the volume's centre, its axis along z. Units: half-steps.
BitVolume torus(Size size, int64_t ring_radius, int64_t tube_radius);

/// Every second voxel: only corner facets, and as many cells as there can be.
BitVolume checkerboard(Size size);

/// A checkerboard in x and y that does not change with z.
BitVolume columns(Size size);

/// The corners of one cell, repeated every two voxels along each axis.
BitVolume tiling(Size size, Configuration configuration);

/// One of the tilings with the most links in their rings.
inline BitVolume tiling_61(Size size) {
  return tiling(size, 61);
}

/// Each voxel is on with a chance of `density` in 256, from a portable generator.
BitVolume random(Size size, uint32_t density, uint64_t seed);

/// Teeth that only the last row joins, so a sweep detects late that they are one region.
BitVolume comb(Size size);

/// A wall two voxels thick that winds inwards in every slice. Its top and bottom have rings that
/// are almost as long as possible. Limit: no side is 0.
BitVolume spiral(Size size);

/// Voxel number i (x fastest) is on if bit i is set. Limit: 64 voxels.
BitVolume from_bits(Size size, uint64_t bits);

}  // namespace discmc::reference
