// Components of surfaces, and their selection.
#include "surface/components.hpp"

#include "hand_made.hpp"
#include "sample_reader.hpp"
#include "test.hpp"

namespace {

using discmc::meshing::Component;
using discmc::meshing::ComponentCounts;
using discmc::meshing::Surface;
using discmc::reference::BitVolume;
using sample_reader::put_box;

const discmc::meshing::Point spacing_mm = {0.5, -2, 3};

// The volume inside the midpoint surface of a box. The surface cuts off corners and edges, so the
// volume is measured on a box alone.
double volume_of_box(int x, int y, int z) {
  BitVolume volume({20, 20, 20});
  put_box(volume, {1, 1, 1}, {x, y, z}, 1);
  return components(sample_reader::surface_of(volume, spacing_mm)).at(0).volume_mm3;
}

}  // namespace

TEST_CASE("a single voxel is an octahedron of a sixth of its volume") {
  CHECK(volume_of_box(1, 1, 1) == doctest::Approx(0.5 * 2 * 3 / 6));
}

TEST_CASE("each separate body is a component, and each cavity is a component of negative volume") {
  BitVolume volume({20, 20, 20});
  put_box(volume, {2, 2, 2}, {10, 10, 10}, 1);
  put_box(volume, {5, 5, 5}, {6, 6, 6}, 0);
  put_box(volume, {14, 14, 14}, {16, 15, 14}, 1);
  const std::vector<Component> found = components(sample_reader::surface_of(volume, spacing_mm));
  REQUIRE(found.size() == 3);
  double volumes[3] = {};
  for (int i = 0; i < 3; ++i) volumes[i] = found[static_cast<std::size_t>(i)].volume_mm3;
  std::sort(volumes, volumes + 3);
  CHECK(volumes[0] < 0);
  CHECK(volumes[1] == doctest::Approx(volume_of_box(3, 2, 1)));
  CHECK(volumes[2] == doctest::Approx(volume_of_box(9, 9, 9)));
  std::size_t polygons = 0;
  for (const Component& component : found) polygons += component.polygons.size();
  CHECK(polygons == sample_reader::surface_of(volume, spacing_mm).polygons.size());
}

TEST_CASE("bodies that touch only at the centroid of a cell are separate") {
  BitVolume volume({4, 4, 4});
  put_box(volume, {1, 1, 1}, {1, 1, 1}, 1);
  put_box(volume, {2, 2, 2}, {2, 2, 2}, 1);
  CHECK(components(sample_reader::surface_of(volume, spacing_mm)).size() == 2);
}

TEST_CASE("polygons are connected if their sides share a link") {
  using hand_made::polygon;
  Surface surface{{1, 1, 1}, polygon({0, 0, 1}, {{{1, 0, 0}, {9, 0, 0}, {9, 8, 0}, {1, 8, 0}}})};
  const auto add_triangle = [&surface](std::int32_t x) {
    surface.polygons.append(polygon({0, -1, 0}, {{{x, 0, 0}, {x + 2, 0, 0}, {x + 1, 0, 1}}}));
  };
  add_triangle(1);
  add_triangle(5);
  CHECK(components(surface).size() == 1);
  add_triangle(9);  // has a vertex in common with the square, but no link
  CHECK(components(surface).size() == 2);
}

TEST_CASE("--largest keeps a body with its cavities, and drops bodies that lie in a cavity") {
  BitVolume volume({40, 20, 20});
  put_box(volume, {1, 1, 1}, {18, 18, 18}, 1);
  put_box(volume, {3, 3, 3}, {16, 16, 16}, 0);
  put_box(volume, {6, 6, 6}, {13, 13, 13}, 1);
  put_box(volume, {8, 8, 8}, {11, 11, 11}, 0);
  put_box(volume, {22, 4, 4}, {32, 14, 14}, 1);
  put_box(volume, {24, 6, 6}, {30, 12, 12}, 0);
  const auto volumes = [](const Surface& surface) {
    std::vector<double> sorted;
    for (const Component& component : components(surface)) sorted.push_back(component.volume_mm3);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const auto kept = [&](const discmc::meshing::ComponentChoice& choice) {
    Surface surface = sample_reader::surface_of(volume, spacing_mm);
    keep_components(surface, choice);
    return volumes(surface);
  };
  const double outer = volume_of_box(18, 18, 18), right = volume_of_box(11, 11, 11),
               inner = volume_of_box(8, 8, 8);
  const std::vector<double> first = kept({1}), second = kept({2}), all = kept({3});
  CHECK(first.size() == 2);
  CHECK(first[1] == doctest::Approx(outer));
  CHECK(second.size() == 4);
  CHECK(second[2] == doctest::Approx(right));
  CHECK(all.size() == 6);
  CHECK(all[3] == doctest::Approx(inner));
  const std::vector<double> filled = kept({1, 0, true});
  REQUIRE(filled.size() == 1);
  CHECK(filled[0] == doctest::Approx(outer));
  const std::vector<Surface> each = bodies(sample_reader::surface_of(volume, spacing_mm));
  REQUIRE(each.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(volumes(each[i]).size() == 2);
  CHECK(volumes(each[0])[1] == doctest::Approx(outer));
  CHECK(volumes(each[2])[1] == doctest::Approx(inner));
  CHECK(volumes(each[2])[0] == doctest::Approx(all[2]));
}

TEST_CASE("components are kept by their rank and by a minimum volume") {
  BitVolume volume({20, 20, 20});
  put_box(volume, {1, 1, 1}, {4, 4, 4}, 1);
  put_box(volume, {10, 10, 10}, {15, 15, 15}, 1);
  put_box(volume, {18, 1, 1}, {18, 1, 1}, 1);
  const auto kept = [&](std::uint64_t largest, double min_volume_mm3) {
    Surface surface = sample_reader::surface_of(volume, spacing_mm);
    const ComponentCounts counts = keep_components(surface, {largest, min_volume_mm3});
    CHECK(counts.found == 3);
    CHECK(components(surface).size() == counts.kept);
    double smallest = 1e9;
    for (const Component& component : components(surface))
      smallest = std::min(smallest, component.volume_mm3);
    return std::pair(counts.kept, smallest);
  };
  const double middle = volume_of_box(4, 4, 4), large = volume_of_box(6, 6, 6);
  CHECK(kept(0, 0) == std::pair(std::uint64_t{3}, volume_of_box(1, 1, 1)));
  CHECK(kept(1, 0).first == 1);
  CHECK(kept(1, 0).second == doctest::Approx(large));
  CHECK(kept(2, 0).second == doctest::Approx(middle));
  CHECK(kept(0, 1.001 * middle).first == 1);
  CHECK(kept(0, 0.999 * middle).first == 2);
  CHECK(kept(9, 1e6).first == 0);
}
