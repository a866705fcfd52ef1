#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <memory>

#include "contenders.hpp"

namespace discmc::bench {

namespace {

constexpr float on = -1, off = 1;
constexpr double adaptivity = 0.1;

openvdb::FloatGrid::Ptr grid_of(const Volume& volume) {
  const auto last = [](uint32_t extent) { return static_cast<int>(extent) - 1; };
  const openvdb::CoordBBox box({0, 0, 0},
                               {last(volume.width), last(volume.height), last(volume.depth)});
  openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, off);
  const std::vector<uint8_t> voxels = voxels_on(volume);
  for (size_t i = 0; i < voxels.size(); ++i)
    if (voxels[i] != 0) dense.data()[i] = on;
  const auto grid = openvdb::FloatGrid::create(off);
  constexpr float exactly = 0;
  openvdb::tools::copyFromDense(dense, *grid, exactly);
  return grid;
}

}  // namespace

Contender adaptive(const Volume& volume) {
  openvdb::initialize();
  return {"OpenVDB", "triangles", [grid = grid_of(volume)] {
            std::vector<openvdb::Vec3s> points;
            std::vector<openvdb::Vec3I> triangles;
            std::vector<openvdb::Vec4I> quads;
            openvdb::tools::volumeToMesh(*grid, points, triangles, quads, 0.0, adaptivity);
            return uint64_t{triangles.size() + 2 * quads.size()};
          }};
}

}  // namespace discmc::bench
