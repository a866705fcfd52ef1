// Masks smoothed to remove the steps of their voxels: extract --smooth.
#include "smoothing/smoothed_volume.hpp"

#include "command.hpp"
#include "mask_shapes.hpp"
#include "meshes/mesh_edges.hpp"
#include "sampled_field.hpp"
#include "smoothing/kept_volumes.hpp"
#include "smoothing/smoothed_labels.hpp"

namespace {

using namespace discmc::command;
using namespace sampled_field;
using command_tests::contains;
using command_tests::volume_of;
using command_tests::Workshop;
using discmc::reference::BitVolume;
using sample_reader::bit_threshold;

Grid grid_of(const BitVolume& volume, const Point& spacing_mm) {
  return {{volume.width, volume.height, volume.depth}, spacing_mm};
}

SliceSource slices_of(const BitVolume& volume) {
  const std::size_t slice = std::size_t{volume.width} * volume.height;
  return [&volume, slice, next = std::size_t{0}](float* samples) mutable {
    std::copy_n(volume.on.begin() + static_cast<std::ptrdiff_t>(next), slice, samples);
    next += slice;
  };
}

template <class Stage>
std::vector<float> all_of(Stage& stage, const Grid& grid) {
  std::vector<float> all(grid.slice_samples() * grid.dims[2]);
  for (std::size_t at = 0; at < all.size(); at += grid.slice_samples()) stage.next(all.data() + at);
  return all;
}

// Units: millimetres.
std::vector<Point> midpoints_of(const BitVolume& volume, const Point& spacing_mm) {
  std::vector<Point> midpoints;
  for (std::uint32_t z = 0; z < volume.depth; ++z)
    for (std::uint32_t y = 0; y < volume.height; ++y)
      for (std::uint32_t x = 0; x < volume.width; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::array<std::uint32_t, 3> next = {x, y, z};
          ++next[axis];
          if (!volume.contains(next[0], next[1], next[2]) ||
              volume.at(x, y, z) == volume.at(next[0], next[1], next[2]))
            continue;
          Point midpoint = {1.0 * x, 1.0 * y, 1.0 * z};
          midpoint[axis] += 0.5;
          for (std::size_t i = 0; i < 3; ++i) midpoint[i] *= spacing_mm[i];
          midpoints.push_back(midpoint);
        }
  return midpoints;
}

double nearest(const std::vector<Point>& points, const Point& to, double limit) {
  for (const Point& point : points)
    limit = std::min(limit, std::hypot(point[0] - to[0], point[1] - to[1], point[2] - to[2]));
  return limit;
}

void check_distances(const BitVolume& volume, const Point& spacing_mm, double limit) {
  const Grid grid = grid_of(volume, spacing_mm);
  SignedDistance distance(grid, limit, slices_of(volume));
  const std::vector<float> distances = all_of(distance, grid);
  const std::vector<Point> midpoints = midpoints_of(volume, spacing_mm);
  double farthest_off = 0;
  for (std::uint32_t z = 0; z < volume.depth; ++z)
    for (std::uint32_t y = 0; y < volume.height; ++y)
      for (std::uint32_t x = 0; x < volume.width; ++x) {
        const Point here = {x * spacing_mm[0], y * spacing_mm[1], z * spacing_mm[2]};
        const double expected = nearest(midpoints, here, limit) * (volume.at(x, y, z) ? 1 : -1);
        const std::size_t at = volume.index(x, y, z);
        farthest_off =
            std::max(farthest_off, std::fabs(static_cast<double>(distances[at]) - expected));
      }
  CHECK(farthest_off < 1e-4);
}

// Options for a volume that has not been read.
FaceMesh mesh_of(SmoothedVolume& volume, double deviation_mm, double tolerance) {
  SurfaceBuilder builder;
  CrossingFinder finder(volume.info(), {0}, {0, 0, 0}, true);
  extract(volume, {{0}, Border::closed}, {{{0}, discmc::make_sink(builder), &finder}});
  Surface& surface = builder.surface();
  surface.spacing_mm = volume.info().spacing_mm;
  keep_volumes({{&surface, &finder.crossings()}},
               SmoothedVolume::keeping(volume.info(), deviation_mm, tolerance, Border::closed));
  return build_mesh(surface, {true, Faces::triangles, &finder.crossings(), tolerance});
}

FaceMesh mesh_of(const SmoothedLabel& label) {
  return build_mesh(label.surface.surface,
                    {true, Faces::triangles, &label.crossings.crossings(), 0.05});
}

struct Smoothed {
  std::vector<float> samples;
  FileMesh mesh;
};

Smoothed smoothed(const BitVolume& volume, const Point& spacing_mm, double deviation_mm) {
  Smoothed result;
  SampleReader reader(volume, spacing_mm);
  SmoothedVolume smooth(reader, {bit_threshold}, nullptr, deviation_mm);
  result.samples.resize(volume.voxels());
  const std::size_t slice = std::size_t{volume.width} * volume.height;
  for (std::size_t at = 0; at < result.samples.size(); at += slice)
    smooth.read_slice(result.samples.data() + at);

  SampleReader again(volume, spacing_mm);
  SmoothedVolume source(again, {bit_threshold}, nullptr, deviation_mm);
  result.mesh = mesh_of(source, deviation_mm, 0.05);
  return result;
}

// With any names and colours in the files.
bool same_mesh(const std::string& obj, const std::string& other) {
  const FileMesh a = command_tests::mesh_of_obj(obj), b = command_tests::mesh_of_obj(other);
  return a.vertices_mm == b.vertices_mm && a.corners == b.corners;
}

// The numbers of bodies and cavities, and the Euler number.
std::pair<std::size_t, std::int64_t> topology_of(const FaceMesh& mesh) {
  Sets pieces = connected_faces(sorted_edges(mesh), mesh.face_count());
  std::set<std::uint32_t> names;
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) names.insert(pieces.root(face));
  const std::set<std::uint32_t> used(mesh.corners.begin(), mesh.corners.end());
  return {names.size(), static_cast<std::int64_t>(used.size()) -
                            static_cast<std::int64_t>(mesh.face_count() / 2)};
}

// The angles between the normals of faces and of a shape, weighted by area.
double mean_degrees(const FaceMesh& mesh, const std::function<Point(const Point&)>& normal_of) {
  double sum = 0, all = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    Point centre{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        centre[axis] += mesh.vertices_mm[mesh.face(face)[i]][axis] / 3;
    const Point normal = unit_or_zero(normal_of(centre)), area = area_vector(mesh, face);
    const double size = std::sqrt(dot(area, area));
    if (normal == Point{} || !(size > 0)) continue;
    sum += size * std::acos(std::clamp(dot(normal, area) / size, -1.0, 1.0));
    all += size;
  }
  return sum / all * 180 / std::acos(-1.0);
}

// A ball of radius 20 mm in voxels that are longer along z, and its centre.
constexpr Point long_voxels = {1, 1, 3};
constexpr double radius = 20;
constexpr Point middle = {29.7, 29.6, 31.8};

BitVolume ball_of_long_voxels() {
  return discmc::reference::volume_of(
      {60, 60, 22}, [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return std::hypot(x - middle[0], y - middle[1], 3 * z - middle[2]) <= radius;
      });
}

Point from_middle(const Point& at) {
  return difference(at, middle);
}

double area_of(const FileMesh& mesh) {
  double sum = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const Point area = area_vector(mesh, face);
    sum += std::sqrt(dot(area, area));
  }
  return sum;
}

// A ball in three parts, 1, 2 and 3, with a common edge through its centre.
std::vector<int> parts_of_a_ball(int extent) {
  std::vector<int> labels;
  const double middle_of_parts = extent / 2.0 - 0.4;
  for (int z = 0; z < extent; ++z)
    for (int y = 0; y < extent; ++y)
      for (int x = 0; x < extent; ++x) {
        const double dx = x - middle_of_parts, dy = y - middle_of_parts, dz = z - middle_of_parts;
        const int part = dy > std::fabs(dx) ? 1 : dx > 0 ? 2 : 3;
        labels.push_back(std::hypot(dx, dy, dz) < extent * 0.375 ? part : 0);
      }
  return labels;
}

}  // namespace

TEST_CASE(
    "the distance field gives the distance to the nearest midpoint for any spacing and limit") {
  for (const double limit : {3.5, 100.0}) {
    check_distances(discmc::reference::random({9, 8, 7}, 128, 1), {1, 1, 1}, limit);
    check_distances(discmc::reference::random({9, 8, 7}, 10, 2), {0.7, 1.1, 2.5}, limit);
    check_distances(discmc::reference::random({1, 12, 5}, 60, 3), {2, 1, 0.5}, limit);
    check_distances(discmc::reference::random({12, 1, 1}, 60, 4), {1, 2, 3}, limit);
    check_distances(discmc::reference::box({14, 13, 12}, {4, 4, 4}, {9, 8, 7}), {1, 1, 3}, limit);
  }
}

TEST_CASE("a Gaussian blur keeps constants, and ramps away from the borders") {
  const Grid grid{{24, 20, 22}, {1, 1, 2}};
  std::uint32_t z = 0;
  GaussianBlur blur(grid, 1.2, [&](float* slice) {
    for (std::uint32_t i = 0; i < grid.slice_samples(); ++i)
      slice[i] = static_cast<float>(5 + 2 * (i % 24) + 3 * (i / 24) + 7 * z);
    ++z;
  });
  const std::vector<float> blurred = all_of(blur, grid);
  for (const std::uint32_t x : {6U, 12U, 17U})
    for (const std::uint32_t y : {5U, 14U})
      for (const std::uint32_t slice : {3U, 10U, 18U})
        CHECK(blurred[(slice * 20 + y) * 24 + x] ==
              doctest::Approx(5.0 + 2 * x + 3 * y + 7 * slice));
}

TEST_CASE("a blurred voxel has the weights of a Gaussian, with a sum of 1") {
  const Grid grid{{15, 15, 15}, {1, 1, 1}};
  BitVolume one({15, 15, 15});
  one.on[one.index(7, 7, 7)] = 1;
  GaussianBlur blur(grid, 1, slices_of(one));
  const std::vector<float> blurred = all_of(blur, grid);
  const auto at = [&](int x, int y, int z) { return blurred[one.index(7 + x, 7 + y, 7 + z)]; };
  for (int i = 1; i <= 3; ++i) {
    const float weight = static_cast<float>(std::exp(-0.5 * i * i));
    CHECK(at(i, 0, 0) / at(0, 0, 0) == doctest::Approx(weight));
    CHECK(at(0, -i, 0) / at(0, 0, 0) == doctest::Approx(weight));
    CHECK(at(0, 0, i) / at(0, 0, 0) == doctest::Approx(weight));
  }
  CHECK(at(4, 0, 0) == 0);
  double sum = 0;
  for (const float each : blurred) sum += static_cast<double>(each);
  CHECK(sum == doctest::Approx(1));
}

TEST_CASE("smoothing keeps the volume and the topology of every shape, and no triangles cross") {
  for (const mask_shapes::Shape& shape : mask_shapes::all()) {
    CAPTURE(shape.name);
    const Size size{shape.dims[0], shape.dims[1], shape.dims[2]};
    SampleReader mask(size, shape.samples, shape.spacing_mm);
    SurfaceBuilder steps;
    extract(mask, {{1}, Border::closed}, {{{1}, discmc::make_sink(steps)}});
    steps.surface().spacing_mm = shape.spacing_mm;
    SampleReader again(size, shape.samples, shape.spacing_mm);
    const double deviation_mm = steps_mm(again.info());
    SmoothedVolume smooth(again, {1}, nullptr, deviation_mm);
    const FaceMesh mesh = mesh_of(smooth, deviation_mm, 0.05);
    CHECK(check_mesh(mesh).is_closed());
    CHECK(topology_of(mesh) == topology_of(build_mesh(steps.surface(), {true, Faces::triangles})));
    CHECK(volume_of(mesh) == doctest::Approx(shape.volume_mm3()).epsilon(0.005));
    CHECK(crossing_pairs(mesh) == 0);
    const std::map<std::string, double> degrees = {{"ball 10", 3.2},
                                                   {"slope", 5.3},
                                                   {"ball of long voxels 15", 3.5},
                                                   {"rod of long voxels", 15}};
    if (const auto most = degrees.find(shape.name); most != degrees.end())
      CHECK(mean_degrees(mesh, shape.normal) < most->second);
  }
}

TEST_CASE("a smoothed ball of voxels is round, also with voxels three times as long") {
  const BitVolume ball = ball_of_long_voxels();
  const FileMesh mesh = smoothed(ball, long_voxels, 3).mesh;
  CHECK(mean_degrees(mesh, from_middle) < 3);
  CHECK(area_of(mesh) == doctest::Approx(4 * std::acos(-1.0) * radius * radius).epsilon(0.01));
  CHECK(volume_of(mesh) ==
        doctest::Approx(3.0 * static_cast<double>(std::count(ball.on.begin(), ball.on.end(), 1)))
            .epsilon(0.012));
}

TEST_CASE("smoothing keeps voxels on their side and does not move flat faces") {
  const BitVolume ball = ball_of_long_voxels();
  const std::vector<float> all = smoothed(ball, long_voxels, 3).samples;
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] * (ball.on[i] != 0 ? 1 : -1) >= 0.05F);
  const BitVolume block = discmc::reference::box({30, 30, 30}, {6, 6, 6}, {23, 23, 23});
  const std::vector<float> samples = smoothed(block, {1, 1, 1}, 1).samples;
  CHECK(samples[block.index(15, 15, 6)] == doctest::Approx(0.5).epsilon(0.01));
  CHECK(samples[block.index(15, 15, 5)] == doctest::Approx(-0.5).epsilon(0.01));
}

TEST_CASE_FIXTURE(Workshop, "--smooth accepts masks, labels and thresholds, and writes triangles") {
  std::string bytes;
  for (const std::uint8_t on : ball_of_long_voxels().on) bytes += static_cast<char>(2 * on);
  write("v.raw", bytes);
  const std::string volume = "extract v.raw --dims 60,60,22 --spacing 1,1,3 --type u8 -q ";
  done(volume + "--iso 1 --smooth auto -o auto.obj");
  CHECK(mean_degrees(mesh_in("auto.obj"), from_middle) < 3);
  for (const std::string same :
       {"--iso 1 --smooth 3", "--label 2 --smooth auto", "--range 1..9 --smooth 3.0",
        "--iso 1 --smooth auto --surface interpolated"}) {
    done(volume + same + " -o same.obj");
    CHECK(same_mesh(read("same.obj"), read("auto.obj")));
  }
  for (const std::string merged : {"-o v.dmc", "-o v.jsonl", "--surface merged -o v.obj",
                                   "--faces polygons -o v.ply", "--no-conforming -o v.ply"})
    CHECK(contains(run(volume + "--iso 1 --smooth auto " + merged).error,
                   "--smooth: has no effect on merged polygons"));

  done(volume + "--iso 1 --smooth 1e-6 -o least.obj");
  for (const std::string none : {"0", "1e-300", "9e-7", "1001"})
    CHECK(contains(run(volume + "--iso 1 --smooth " + none + " -o v.stl").error,
                   "invalid deviation '" + none + "'; expected auto, or 1e-6 to 1000 millimetres"));
}

TEST_CASE("smoothing with a mask gives the same result as cutting by the mask before smoothing") {
  const BitVolume ball = ball_of_long_voxels();
  const BitVolume half = discmc::reference::box({60, 60, 22}, {0, 0, 0}, {30, 59, 21});
  BitVolume both = ball;
  for (std::size_t i = 0; i < both.on.size(); ++i)
    both.on[i] = static_cast<std::uint8_t>(both.on[i] & half.on[i]);
  SampleReader samples(ball), expected(both);
  std::vector<int> ones;
  for (const std::uint8_t on : half.on) ones.push_back(on);
  SampleReader mask({60, 60, 22}, ones);
  SmoothedVolume cut(samples, {bit_threshold}, &mask, 1.5);
  SmoothedVolume whole(expected, {bit_threshold}, nullptr, 1.5);
  std::vector<float> a(60 * 60), b(60 * 60);
  for (int z = 0; z < 22; ++z) {
    cut.read_slice(a.data());
    whole.read_slice(b.data());
    CHECK(a == b);
  }
}

TEST_CASE("labels are smoothed separately and keep their volumes") {
  const int extent = 48;
  const std::vector<int> samples = parts_of_a_ball(extent);
  SampleReader reader({48, 48, 48}, samples);
  std::vector<std::size_t> progress;
  const std::vector<SmoothedLabel> labels =
      smoothed_labels(reader, {}, 1, 0.05,
                      [&](std::size_t done, std::size_t all) { progress.push_back(all - done); });
  REQUIRE(labels.size() == 3);
  CHECK(progress == std::vector<std::size_t>{2, 1, 0});
  double all = 0;
  for (const SmoothedLabel& label : labels) {
    const double volume = volume_of(mesh_of(label));
    CHECK(volume == doctest::Approx(static_cast<double>(label.surface.voxels)).epsilon(0.01));
    all += volume;
  }
  CHECK(all == doctest::Approx(static_cast<double>(samples.size()) -
                               static_cast<double>(std::count(samples.begin(), samples.end(), 0)))
                   .epsilon(0.01));
}

TEST_CASE(
    "smoothing keeps the volumes of small labels alone, beside others, inside others and in long "
    "voxels") {
  for (const Point& spacing : {Point{1, 1, 1}, Point{0.8, 0.8, 3}}) {
    std::vector<int> samples(40 * 30 * 24);
    const auto put = [&](int label, const std::array<int, 3>& first,
                         const std::array<int, 3>& end) {
      for (int z = first[2]; z < end[2]; ++z)
        for (int y = first[1]; y < end[1]; ++y)
          for (int x = first[0]; x < end[0]; ++x)
            samples[static_cast<std::size_t>((z * 30 + y) * 40 + x)] = label;
    };
    put(1, {4, 4, 4}, {20, 24, 18});
    put(2, {20, 6, 6}, {28, 14, 12});    // beside 1
    put(3, {10, 10, 10}, {12, 12, 12});  // inside 1
    put(4, {33, 4, 4}, {34, 5, 5});
    put(5, {32, 12, 8}, {35, 15, 11});
    put(6, {31, 22, 6}, {36, 27, 7});
    put(7, {20, 14, 6}, {28, 20, 12});  // beside 1 and 2
    SampleReader reader({40, 30, 24}, samples, spacing);
    const std::vector<SmoothedLabel> labels =
        smoothed_labels(reader, {}, steps_mm(reader.info()), 0.05, {});
    REQUIRE(labels.size() == 7);
    for (const SmoothedLabel& label : labels) {
      CAPTURE(label.surface.label.text());
      const FaceMesh mesh = mesh_of(label);
      CHECK(check_mesh(mesh).is_closed());
      CHECK(volume_of(mesh) == doctest::Approx(static_cast<double>(label.surface.voxels) *
                                               spacing[0] * spacing[1] * spacing[2])
                                   .epsilon(0.01));
    }
  }
}

// Labels lose volume along the edges of three labels. Sequential rounds would not move enough from
// the outside to the centre.
TEST_CASE(
    "smoothing touching labels in a ball distributes the unavoidable loss of volume in equal "
    "shares") {
  const int extent = 72, block = 6;
  std::vector<int> samples;
  for (int z = 0; z < extent; ++z)
    for (int y = 0; y < extent; ++y)
      for (int x = 0; x < extent; ++x) {
        const int label = (z / block * 100 + y / block) * 100 + x / block;
        samples.push_back(std::hypot(x - 35.5, y - 35.4, z - 35.3) < 34 ? label : 0);
      }
  SampleReader reader({72, 72, 72}, samples);
  double farthest = 0;
  for (const SmoothedLabel& label : smoothed_labels(reader, {}, 1.5, 0.05, {})) {
    if (label.surface.voxels < block * block * block) continue;
    MeshingOptions options{true, Faces::triangles, &label.crossings.crossings(), 0.05};
    options.separates = false;
    const double volume = volume_of(build_mesh(label.surface.surface, options));
    const auto voxels = static_cast<double>(label.surface.voxels);
    farthest = std::max(farthest, std::fabs(volume / voxels - 1));
  }
  CHECK(farthest < 0.015);
}

TEST_CASE(
    "labels that fill the volume to its corners lose equal shares of their volumes in smoothing") {
  std::vector<int> samples;
  for (int i = 0; i < 24 * 20 * 20; ++i) samples.push_back(i % 24 < 4 && i / 24 % 20 < 4 ? 1 : 2);
  SampleReader reader({24, 20, 20}, samples);
  const std::vector<SmoothedLabel> labels = smoothed_labels(reader, {}, 1.5, 0.05, {});
  REQUIRE(labels.size() == 2);
  std::vector<double> shares;
  for (const SmoothedLabel& label : labels)
    shares.push_back(volume_of(mesh_of(label)) / static_cast<double>(label.surface.voxels));
  CHECK(shares[0] < 0.999);
  CHECK(shares[0] == doctest::Approx(shares[1]).epsilon(0.001));
}

TEST_CASE("smoothing refuses more than 1,024 scattered labels, and reports each slice") {
  std::vector<int> samples(max_scattered_labels + 2);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<int>(i);
  SampleReader scattered({max_scattered_labels + 2, 1, 1}, samples, {1, 1, 1}, SampleType::u16);
  CHECK_THROWS_WITH_AS(smoothed_labels(scattered, {}, 1, 0.05, {}),
                       doctest::Contains("more than 1024 values up to slice 0"),
                       std::invalid_argument);
  SampleReader few({1, 1, 4}, {0, 1, 1, 0});
  LabelOptions options;
  std::vector<std::uint32_t> progress;
  options.progress = [&progress](std::uint32_t slices) { progress.push_back(slices); };
  smoothed_labels(few, options, 1, 0.05, {});
  CHECK(progress == std::vector<std::uint32_t>{1, 2, 3, 4});
}

TEST_CASE("smoothing accepts any number of scattered label values if few are close together") {
  // The labels exceed the limit per slice if they are scattered, but few are close together.
  std::vector<int> samples;
  for (int i = 0; i < 2 * static_cast<int>(max_scattered_labels); ++i)
    samples.insert(samples.end(), {i + 1, 0, 0, 0});
  SampleReader reader({1, 1, static_cast<std::uint32_t>(samples.size())}, samples, {1, 1, 1},
                      SampleType::u16);
  CHECK(smoothed_labels(reader, {}, 0.3, 0.05, {}).size() == 2 * max_scattered_labels);
}

TEST_CASE("smoothing a label within its bounding box equals smoothing in the whole volume") {
  const BitVolume block = discmc::reference::box({40, 30, 20}, {20, 3, 2}, {33, 9, 12});
  std::vector<int> samples;
  for (const std::uint8_t on : block.on) samples.push_back(7 * on);
  SampleReader reader({40, 30, 20}, samples);
  const std::vector<SmoothedLabel> labels = smoothed_labels(reader, {}, 1, 0.05, {});
  REQUIRE(labels.size() == 1);
  const FileMesh of_box = mesh_of(labels[0]);
  const FileMesh of_whole = smoothed(block, {1, 1, 1}, 1).mesh;
  CHECK(of_box.corners == of_whole.corners);
  REQUIRE(of_box.vertices_mm.size() == of_whole.vertices_mm.size());
  for (std::size_t i = 0; i < of_box.vertices_mm.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(of_box.vertices_mm[i][axis] ==
            doctest::Approx(of_whole.vertices_mm[i][axis]).epsilon(1e-4));
}

TEST_CASE("adjacent labels share their smoothed surface") {
  std::vector<int> samples;
  for (int i = 0; i < 30 * 20 * 20; ++i) samples.push_back(i % 30 < 17 ? 4 : 9);
  SampleReader reader({30, 20, 20}, samples);
  const std::vector<SmoothedLabel> labels = smoothed_labels(reader, {}, 1, 0.05, {});
  REQUIRE(labels.size() == 2);
  for (const SmoothedLabel& label : labels) {
    const FileMesh mesh = mesh_of(label);
    double nearest_to_seam = 100;
    for (const Point& vertex : mesh.vertices_mm)
      nearest_to_seam = std::min(nearest_to_seam, std::fabs(vertex[0] - 16.5));
    CHECK(nearest_to_seam < 5e-3);  // voxels
    CHECK(volume_of(mesh) == doctest::Approx((label.surface.label == 4 ? 17 : 13) * 400)
                                 .epsilon(0.006));  // edges are cut
  }
}

TEST_CASE_FIXTURE(Workshop, "--smooth with --labels writes a smooth mesh of each label") {
  std::string bytes;
  for (const int label : parts_of_a_ball(48)) bytes += static_cast<char>(label);
  write("v.raw", bytes);
  const std::string extract = "extract v.raw --dims 48,48,48 --type u8 -q --smooth auto ";
  done(extract + "--labels all -o '{name}.obj'");
  done(extract + "--label 2 -o label.obj");
  CHECK(same_mesh(read("2.obj"), read("label.obj")));
  done(extract + "--labels 1,3 -o all.glb");
  done(extract + "--labels 2 -o '{name}-alone.obj'");
  CHECK(same_mesh(read("2-alone.obj"), read("label.obj")));
}
