// The points at which samples cross the threshold.
#include "extraction/crossings.hpp"

#include <discmc/geometry/facet_table.hpp>

#include "sampled_field.hpp"
#include "test.hpp"

namespace {

using namespace sampled_field;

// The crossing on the edge from a voxel along an axis, computed from the formula of the samples.
// Units: half-steps.
Point crossing(const Field& field, const Vertex& voxel, std::size_t axis) {
  const Vertex to = {voxel.x + (axis == 0 ? 1 : 0), voxel.y + (axis == 1 ? 1 : 0),
                     voxel.z + (axis == 2 ? 1 : 0)};
  const double a = field.at(voxel.x, voxel.y, voxel.z), b = field.at(to.x, to.y, to.z);
  Point point = {2.0 * voxel.x, 2.0 * voxel.y, 2.0 * voxel.z};
  point[axis] += std::clamp(2 * (level - a) / (b - a), Crossings::margin, 2 - Crossings::margin);
  return point;
}

void check_near(const Point& a, const Point& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(std::abs(a[axis] - b[axis]) < 1e-6);
}

// The points around the centroid of a cell, from the facets with a corner there.
std::set<discmc::CellPoint> around_centroid(discmc::Configuration configuration) {
  std::set<discmc::CellPoint> points;
  for (int i = discmc::facet_table.first[configuration];
       i < discmc::facet_table.first[configuration + 1]; ++i) {
    const discmc::FacetRing& ring = discmc::facet_rings.ring[discmc::facet_table.facet[i]];
    if (std::count(ring.point, ring.point + ring.count, discmc::centroid) > 0)
      points.insert(ring.point, ring.point + ring.count);
  }
  points.erase(discmc::centroid);
  return points;
}

}  // namespace

TEST_CASE(
    "a vertex in the middle of an edge is moved to the linearly interpolated crossing of the "
    "samples") {
  const Field field = noise({7, 6, 5}, 1);
  const Extracted of = extracted(field);
  std::size_t moved = 0;
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 7; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Vertex step = {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
          const Vertex to = Vertex{x, y, z} + step;
          if (to.x == 7 || to.y == 6 || to.z == 5) continue;
          if ((field.at(x, y, z) >= threshold) == (field.at(to.x, to.y, to.z) >= threshold))
            continue;
          const Vertex middle = Vertex{x, y, z} + to;
          check_near(of.finder.crossings().interpolated(middle), crossing(field, {x, y, z}, axis));
          ++moved;
        }
  CHECK(moved > 100);
}

TEST_CASE(
    "a cell's centroid is moved to the mean of the surrounding crossings, also at the border") {
  const Field field = noise({6, 7, 6}, 2);
  const Extracted of = extracted(field);
  const Crossings& crossings = of.finder.crossings();
  std::set<std::size_t> counts;
  for (int z = -1; z < 6; ++z)
    for (int y = -1; y < 7; ++y)
      for (int x = -1; x < 6; ++x) {
        discmc::Configuration configuration = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
          const int at[] = {x + static_cast<int>(corner & 1), y + static_cast<int>(corner >> 1 & 1),
                            z + static_cast<int>(corner >> 2)};
          const bool is_inside =
              at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < 6 && at[1] < 7 && at[2] < 6;
          if (is_inside && field.at(at[0], at[1], at[2]) >= threshold)
            configuration = static_cast<discmc::Configuration>(configuration | 1U << corner);
        }
        const auto points = around_centroid(configuration);
        if (points.empty()) continue;
        Point mean{};
        for (const discmc::CellPoint point : points) {
          const Point at =
              crossings.interpolated(Vertex{2 * x, 2 * y, 2 * z} + discmc::position(point));
          for (std::size_t axis = 0; axis < 3; ++axis)
            mean[axis] += at[axis] / static_cast<double>(points.size());
        }
        check_near(crossings.interpolated({2 * x + 1, 2 * y + 1, 2 * z + 1}), mean);
        counts.insert(points.size());
      }
  CHECK(counts == std::set<std::size_t>{4, 5, 6, 7});
}

TEST_CASE("crossings do not depend on the type of the samples") {
  const Field field = noise({9, 5, 4}, 3);
  const Extracted of_bytes = extracted(field);
  for (const auto& called : sample_types) {
    INFO(called.first);
    const Extracted of = extracted(field, called.second);
    REQUIRE(of.surface.polygons.size() == of_bytes.surface.polygons.size());
    for (const Polygon& polygon : of.surface.polygons)
      for (const Ring& ring : polygon.rings)
        for (const Vertex& vertex : ring)
          REQUIRE(of.finder.crossings().interpolated(vertex) ==
                  of_bytes.finder.crossings().interpolated(vertex));
  }
}

TEST_CASE("an edge crosses a range at the end of the range that its samples enclose") {
  VolumeInfo info;
  info.dims = {4, 1, 1};
  const std::uint8_t samples[] = {0, 20, 100, 20};
  CrossingFinder finder(info, {10, 59});
  finder.add_slice(samples);
  check_near(finder.crossings().interpolated({1, 0, 0}), {0.95, 0, 0});
  check_near(finder.crossings().interpolated({3, 0, 0}), {2 + 2 * 39.5 / 80, 0, 0});
  check_near(finder.crossings().interpolated({5, 0, 0}), {4 + 2 * 40.5 / 80, 0, 0});
}

TEST_CASE("an edge to a voxel that the mask excludes is crossed in the middle") {
  VolumeInfo info;
  info.dims = {5, 1, 1};
  const std::uint8_t samples[] = {100, 80, 20, 100, 20};
  const std::uint8_t mask = 0b01001;
  CrossingFinder finder(info, {threshold});
  finder.add_slice(samples, &mask);
  check_near(finder.crossings().interpolated({1, 0, 0}), {1, 0, 0});
  check_near(finder.crossings().interpolated({3, 0, 0}), {3, 0, 0});  // on neither side
  check_near(finder.crossings().interpolated({5, 0, 0}), {4 + 2 * 29.5 / 80, 0, 0});
  check_near(finder.crossings().interpolated({7, 0, 0}), {6 + 2 * 50.5 / 80, 0, 0});
}

TEST_CASE("an edge to a non-finite sample, or out of the volume, is crossed in the middle") {
  VolumeInfo info;
  info.dims = {7, 1, 1};
  info.type = SampleType::f32;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float samples[] = {100, std::nanf(""), 100, -infinity, infinity, 0, 100};
  CrossingFinder finder(info, {threshold});
  finder.add_slice(samples);
  for (int x = -1; x <= 9; x += 2)
    check_near(finder.crossings().interpolated({x, 0, 0}), {static_cast<double>(x), 0, 0});
  check_near(finder.crossings().interpolated({11, 0, 0}), {11, 0, 0});
  check_near(finder.crossings().interpolated({13, 0, 0}), {13, 0, 0});
  check_near(finder.crossings().interpolated({0, 1, 0}), {0, 1, 0});
}

TEST_CASE("a crossing keeps a distance from the voxels") {
  VolumeInfo info;
  info.dims = {3, 1, 1};
  info.type = SampleType::f64;
  const double samples[] = {0, threshold, 0};
  CrossingFinder finder(info, {threshold});
  finder.add_slice(samples);
  check_near(finder.crossings().interpolated({1, 0, 0}), {2 - Crossings::margin, 0, 0});
  check_near(finder.crossings().interpolated({3, 0, 0}), {2 + Crossings::margin, 0, 0});
}
