#include "vertex_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <discmc/normal.hpp>
#include <discmc/polygon.hpp>
#include <discmc/sample_window.hpp>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "samples/spacing.hpp"

namespace discmc::meshing {
namespace {

// Scales the spacing. Only ratios count, so scaled nanometres are exact enough and fit.
Point scaled(Point spacing_mm) {
  constexpr double min_mm = 0.01, max_mm = 2000, nanometre = 1e-6;
  double shortest = std::fabs(spacing_mm[0]), longest = shortest;
  for (const double along : spacing_mm) {
    shortest = std::min(shortest, std::fabs(along));
    longest = std::max(longest, std::fabs(along));
  }
  if (shortest == 0 || (shortest >= min_mm && longest <= max_mm)) return spacing_mm;
  for (double& along : spacing_mm)
    along = std::copysign(std::max(std::fabs(along) / longest * max_mm, nanometre), along);
  return spacing_mm;
}

AxisWeights weights_of(const FaceMesh& mesh) {
  const auto spacing = spacing_nm(scaled(mesh.spacing_mm));
  return axis_weights({spacing[0], spacing[1], spacing[2]});
}

Point as_point(const UnitNormal& normal) {
  constexpr double one = UnitNormal::one;
  return {normal.x / one, normal.y / one, normal.z / one};
}

Point normal_along(const LongVector& direction, const AxisWeights& weights) {
  return as_point(unit_normal(weighted(direction, weights)));
}

LongVector whole_area_vector(const Polygon& polygon) {
  std::int64_t doubled = 0;
  for (const Ring& ring : polygon.rings)
    doubled += twice_area(polygon.incidence, ring.data(), static_cast<std::uint32_t>(ring.size()));
  return discmc::area_vector(polygon.incidence, doubled);
}

// Returns the numbers of all vertices, lowest z first.
std::vector<std::uint32_t> upwards(const std::vector<Vertex>& lattice) {
  std::vector<std::uint32_t> order(lattice.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&lattice](std::uint32_t a, std::uint32_t b) { return lattice[a].z < lattice[b].z; });
  return order;
}

void require_valid(Status status) {
  if (status != Status::ok) throw std::invalid_argument(to_string(status));
}

template <class Sample>
void set_from_samples(SliceReader& volume, FaceMesh& mesh,
                      const std::function<void(std::uint32_t)>& progress) {
  const SampleGrid& info = volume.info();
  const Limits limits{info.dims[0], info.dims[1]};
  std::vector<std::uint8_t> memory(SampleWindow<Sample>::bytes_for(limits));
  SampleWindow<Sample> window;
  require_valid(window.start(limits, {memory.data(), memory.size()}));

  const AxisWeights weights = weights_of(mesh);
  const std::vector<std::uint32_t> order = upwards(mesh.lattice);
  auto next = order.begin();
  const auto set_covered = [&] {
    for (; next != order.end() && window.covers(mesh.lattice[*next]); ++next) {
      const Point normal = normal_along(window.negative_gradient(mesh.lattice[*next]), weights);
      if (normal != Point{}) mesh.normals[*next] = normal;
    }
  };
  std::vector<Sample> slice(info.slice_bytes() / sizeof(Sample));
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    require_valid(window.push(slice.data(), static_cast<std::uint32_t>(slice.size())));
    set_covered();
    if (progress) progress(z + 1);
  }
  window.end();
  set_covered();
}

}  // namespace

void set_polygon_normals(const Surface& surface, FaceMesh& mesh) {
  std::vector<LongVector> sums(mesh.lattice.size(), LongVector{0, 0, 0});
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> last(sums.size(), none);  // first face of the last added polygon
  std::size_t face = 0;
  while (face < mesh.face_count()) {
    // Faces of a polygon follow each other.
    const std::size_t begin = face;
    const std::uint32_t polygon = mesh.polygons[begin];
    while (face < mesh.face_count() && mesh.polygons[face] == polygon) ++face;
    const LongVector area = whole_area_vector(surface.polygons[polygon]);
    for (std::size_t i = mesh.face_begin[begin]; i < mesh.face_begin[face]; ++i) {
      const std::uint32_t vertex = mesh.corners[i];
      if (last[vertex] == begin) continue;
      last[vertex] = begin;
      sums[vertex] = sums[vertex] + area;
    }
  }
  const AxisWeights weights = weights_of(mesh);
  mesh.normals.clear();
  for (const LongVector& sum : sums) mesh.normals.push_back(normal_along(sum, weights));
}

void set_stream_normals(const Surface& surface, FaceMesh& mesh) {
  mesh.normals.resize(mesh.lattice.size());
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    const auto found = surface.normals.find(mesh.lattice[i]);
    if (found != surface.normals.end()) mesh.normals[i] = as_point(unit_normal(found->second));
  }
}

void set_gradient_normals(SliceReader& volume, FaceMesh& mesh,
                          const std::function<void(std::uint32_t)>& progress) {
  mesh.normals.resize(mesh.vertices_mm.size());
  with_scanner_type(volume.info().type,
                    [&](auto type) { set_from_samples<decltype(type)>(volume, mesh, progress); });
}

}  // namespace discmc::meshing
