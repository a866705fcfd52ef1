// The angles between the normals of a mesh and normals in double precision.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <discmc/normal.hpp>
#include <discmc/sink.hpp>

#include "extraction/extraction.hpp"
#include "meshes/mesh.hpp"
#include "oracle/angle.hpp"
#include "oracle/gradient.hpp"
#include "samples/spacing.hpp"
#include "surface/surface_builder.hpp"
#include "volumes/volume.hpp"

namespace normal_angles {

using discmc::meshing::FaceMesh;
using discmc::meshing::Point;
using discmc::reference::Angles;
using discmc::reference::degrees_between;
using discmc::reference::SampleVolume;

/// The closed surface of a volume.
inline discmc::meshing::Surface surface_of(discmc::command::VolumeReader& volume,
                                           std::int32_t threshold) {
  discmc::meshing::SurfaceBuilder builder;
  extract(volume, {{static_cast<double>(threshold)}, discmc::Border::closed},
          discmc::make_sink(builder));
  builder.surface().spacing_mm = volume.info().spacing_mm;
  return builder.surface();
}

/// The compared vertices: with a gradient of at least this many samples per voxel.
constexpr double steep = 8;

struct NormalAngles {
  std::size_t level = 0;           ///< vertices without a gradient
  Angles fixed_point, octahedral;  ///< where steep: of the mesh, and in two bytes
};

/// Compares gradient normals of a mesh with central differences in its volume.
inline NormalAngles compare(const FaceMesh& mesh, const SampleVolume<int>& volume) {
  const auto nm = discmc::meshing::spacing_nm(mesh.spacing_mm);
  const discmc::AxisWeights weights = discmc::axis_weights({nm[0], nm[1], nm[2]});
  NormalAngles result;
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    const std::array<double, 3> up = gradient(volume, mesh.lattice[i]);
    const double length = std::hypot(up[0], up[1], up[2]);
    result.level += length == 0 ? 1U : 0U;
    if (length < steep) continue;
    const Point& s = mesh.spacing_mm;
    const Point expected = {-up[0] / s[0], -up[1] / s[1], -up[2] / s[2]};
    result.fixed_point.add(degrees_between(mesh.normals[i], expected));
    // Sums of halves over at most eight voxels.
    const discmc::LongVector down = {std::llround(-16 * up[0]), std::llround(-16 * up[1]),
                                     std::llround(-16 * up[2])};
    const discmc::UnitNormal unit =
        discmc::unit_normal(discmc::octahedral_normal(discmc::weighted(down, weights)));
    result.octahedral.add(degrees_between({unit.x * 1.0, unit.y * 1.0, unit.z * 1.0}, expected));
  }
  return result;
}

/// Compares the normals of a ball in the middle of a volume of cubes with its radii.
inline Angles compare_with_radii(const FaceMesh& mesh, std::uint32_t extent) {
  const double centre = (extent - 1) / 2.0;
  Angles angles;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const Point& at = mesh.vertices_mm[i];
    angles.add(degrees_between(mesh.normals[i], {at[0] - centre, at[1] - centre, at[2] - centre}));
  }
  return angles;
}

}  // namespace normal_angles
