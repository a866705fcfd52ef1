// The accuracy of the normals of merged surfaces, on generated balls and on volumes from files.
//
//   bench_normals
//   bench_normals ct_quarter.nrrd:500 cthead.nrrd:500 engine.nii.gz:80

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "command/normal_angles.hpp"
#include "command/sample_reader.hpp"
#include "comparison/volumes.hpp"
#include "meshes/vertex_normals.hpp"
#include "oracle/ramp_ball.hpp"
#include "volumes/volume.hpp"

using namespace discmc;
using namespace discmc::command;
using namespace normal_angles;
using reference::Ramp;

namespace {

constexpr const char* usage =
    R"(usage: bench_normals [FILE:THRESHOLD]...

Compares the gradient normals at all vertices of the merged, conforming surface with central
differences in double precision, where these are at least 8 samples a voxel, and both gradient and
surface normals of balls with their radii. THRESHOLD is on stored samples; FILE as discmc extract
takes it.

Exit status: 0, or 1 if a file could not be read, or 2 for an argument that is not understood.
)";

// ---- volumes ----

reference::SampleVolume<int> samples_of(const std::string& path) {
  const bench::Volume read = bench::read_volume(path);
  reference::SampleVolume<int> volume{{read.width, read.height, read.depth}, {}};
  std::visit([&](const auto& samples) { volume.samples.assign(samples.begin(), samples.end()); },
             read.samples);
  return volume;
}

struct File {
  std::string path;
  int32_t threshold;
};

bool parse(std::string_view argument, File& file) {
  const size_t colon = argument.rfind(':');
  if (colon == std::string_view::npos) return false;
  file.path = argument.substr(0, colon);
  const char* const end = argument.data() + argument.size();
  const auto result = std::from_chars(argument.data() + colon + 1, end, file.threshold);
  return result.ec == std::errc() && result.ptr == end;
}

// ---- the tables ----

double percent(size_t part, size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_row(const std::string& name, const FaceMesh& mesh, const NormalAngles& angles) {
  const size_t vertices = mesh.normals.size();
  std::printf("%-28s %9zu %8.3f %8.2f %9.5f %9.5f %9.3f %9.3f\n", name.c_str(), vertices,
              percent(angles.level, vertices), percent(angles.fixed_point.count, vertices),
              angles.fixed_point.mean(), angles.fixed_point.worst, angles.octahedral.mean(),
              angles.octahedral.worst);
}

void print_head() {
  std::printf("%-28s %9s %8s %8s %19s %19s\n", "degrees from double", "", "level", "steep",
              "fixed point", "octahedral");
  std::printf("%-28s %9s %8s %8s %9s %9s %9s %9s\n", "", "vertices", "%", "%", "mean", "worst",
              "mean", "worst");
}

struct Ball {
  std::string name;
  Angles gradient, surface;  // compared with the radii
};

Ball measure_ball(double radius, const char* kind, SampleType type, const Ramp& ramp) {
  const auto extent = 2 * static_cast<uint32_t>(radius) + 12;
  const reference::SampleVolume<int> volume = reference::ramp_ball(extent, radius, ramp);
  const auto reader = [&] {
    return sample_reader::SampleReader(volume.size, volume.samples, {1, 1, 1}, type);
  };
  auto first = reader();
  const Surface surface = surface_of(first, ramp.threshold);
  FaceMesh mesh = build_mesh(surface);
  Ball ball;
  ball.name = "ball " + std::to_string(static_cast<int>(radius)) + ", " + kind;
  set_polygon_normals(surface, mesh);
  ball.surface = compare_with_radii(mesh, extent);
  auto second = reader();
  set_gradient_normals(second, mesh);
  ball.gradient = compare_with_radii(mesh, extent);
  print_row(ball.name, mesh, compare(mesh, volume));
  return ball;
}

std::vector<Ball> measure_balls() {
  struct Kind {
    const char* name;
    SampleType type;
    Ramp ramp;
  };
  // Samples beyond the range of the type are clamped.
  const Kind kinds[] = {{"step of 255", SampleType::u8, {1e6, 128, 255}},
                        {"8 a voxel", SampleType::u8, {8, 128, 255}},
                        {"32 a voxel", SampleType::u8, {32, 128, 255}},
                        {"1000 a voxel", SampleType::u16, {1000, 32768, 65535}}};
  std::vector<Ball> balls;
  for (const double radius : {5.0, 10.0, 20.0, 40.0, 80.0})
    for (const Kind& kind : kinds)
      balls.push_back(measure_ball(radius, kind.name, kind.type, kind.ramp));
  return balls;
}

void measure_file(const File& file) {
  const Surface surface = surface_of(*open_volume(file.path), file.threshold);
  FaceMesh mesh = build_mesh(surface);
  set_gradient_normals(*open_volume(file.path), mesh);
  const std::string name = file.path.substr(file.path.rfind('/') + 1);
  print_row(name + " at " + std::to_string(file.threshold), mesh,
            compare(mesh, samples_of(file.path)));
}

void print_balls(const std::vector<Ball>& balls) {
  std::printf("\n%-28s %19s %19s\n", "degrees from the radii", "gradient", "surface");
  std::printf("%-28s %9s %9s %9s %9s\n", "", "mean", "worst", "mean", "worst");
  for (const Ball& ball : balls)
    std::printf("%-28s %9.3f %9.3f %9.2f %9.2f\n", ball.name.c_str(), ball.gradient.mean(),
                ball.gradient.worst, ball.surface.mean(), ball.surface.worst);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<File> files;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--help") return std::fputs(usage, stdout) < 0 ? 1 : 0;
    if (!parse(argv[i], files.emplace_back())) {
      std::fprintf(stderr, "bench_normals: %s: not FILE:THRESHOLD\n%s", argv[i], usage);
      return 2;
    }
  }
  try {
    print_head();
    const std::vector<Ball> balls = measure_balls();
    for (const File& file : files) measure_file(file);
    print_balls(balls);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_normals: %s\n", error.what());
    return 1;
  }
  return 0;
}
