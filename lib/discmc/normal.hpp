// Normals in integers: fixed-point unit vectors from vectors of any length.
//
// A normal points outwards, from on to off. unit_normal(weighted(vector, axis_weights(spacing)))
// makes a unit vector of any vector below. A normal that arrives in a stream already includes the
// spacing, and needs only unit_normal(). The sources of a vector:
//
//   the facet      incidence_normal(incidence) of lattice.hpp: exact, at almost no cost
//   the samples    SampleWindow::negative_gradient(): Montani et al. 1994, section 2.4; may point
//                  inwards at walls thinner than two voxels
//   the polygons   the sum of area_vector() over the polygons that meet in a vertex
#ifndef DISCMC_NORMAL_HPP
#define DISCMC_NORMAL_HPP

#include <discmc/lattice.hpp>

namespace discmc {

/// A vector of any length and unit.
struct LongVector {
  int64_t x, y, z;
};

constexpr LongVector operator+(const LongVector& a, const LongVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// A unit vector in fixed point, Q1.14. All zero if there is no normal.
struct UnitNormal {
  static constexpr int32_t one = 1 << 14;
  int16_t x, y, z;
};

/// A unit vector in two bytes: its point on the octahedron |x| + |y| + |z| = 127, with 128 added to
/// x and y. The lower half (z < 0) is folded outwards. If there is no normal, u is 0. Error: at
/// most 0.96 degrees. See Meyer et al., "On Floating-Point Normal Vectors", 2010.
struct OctahedralNormal {
  uint8_t u, v;

  constexpr bool is_none() const { return u == 0; }
};

constexpr bool operator==(const UnitNormal& a, const UnitNormal& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
constexpr bool operator!=(const UnitNormal& a, const UnitNormal& b) {
  return !(a == b);
}
constexpr bool operator==(const OctahedralNormal& a, const OctahedralNormal& b) {
  return a.u == b.u && a.v == b.v;
}
constexpr bool operator!=(const OctahedralNormal& a, const OctahedralNormal& b) {
  return !(a == b);
}

/// The factors for the components of a normal if voxels are not cubes: 1 / spacing times a common
/// factor. Normals transform with the inverse of the spacing. axis_weights() computes them. Limit:
/// no factor is -2^31.
struct AxisWeights {
  int32_t x = 1, y = 1, z = 1;
};

/// The weights of a spacing. Units: any; negative for a mirrored axis. If a component is zero
/// (unknown), voxels count as cubes. Error: at most 2^-30 of the largest weight.
AxisWeights axis_weights(const int32_t (&spacing)[3]);

/// Corrects a normal or gradient for voxels that are not cubes. Only the direction of the result
/// matters: pass it to unit_normal(). Error: none if all components are below 2^31, otherwise at
/// most 2^-31 of the largest component.
LongVector weighted(const LongVector& vector, const AxisWeights& weights);

/// The unit vector of a direction of any length; none for the zero vector. Error: at most 0.006
/// degrees. Cost: three 32-bit divisions and a square root.
UnitNormal unit_normal(const LongVector& direction);
/// As above, in two bytes. Error: at most 0.96 degrees. Cost: two 32-bit divisions.
OctahedralNormal octahedral_normal(const LongVector& direction);

/// Decodes an octahedral normal. Any bytes are safe.
UnitNormal unit_normal(OctahedralNormal normal);

/// The contribution of a polygon to the normals of its vertices: a vector along its normal, twelve
/// times as long as its area. twice_area: the sum of twice_area() over all rings of the polygon
/// (chain.hpp, polygon.hpp). Units: half-steps.
constexpr LongVector area_vector(Incidence incidence, int64_t twice_area) {
  const Vertex n = incidence_normal(incidence);
  // twice_area contains the length of n as a factor, and n does too: 6 / |n|^2 removes both.
  const int64_t length = twice_area * (6 / dot_product(n, n));
  return {n.x * length, n.y * length, n.z * length};
}

}  // namespace discmc

#endif
