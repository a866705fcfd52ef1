// Compares the times of discmc and other libraries, in one process and on one thread. scripts/bench
// builds and runs it.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string_view>

#include "report.hpp"

namespace discmc::bench {

namespace {

constexpr const char* usage = R"(usage: bench [--short] [FOLDER]

What scripts/bench runs; see its --help.
)";

constexpr const char* notes = R"(
counting, polygons, stream: discmc with a sink that counts regions, one that keeps their corners in
  arrays, and the encoder; from start() on, 32-bit indices, memory for the worst case.
FlyingEdges3D: VTK's; interpolated triangles, nothing merged, no normals.
DecimatePro, meshoptimizer: VTK's DiscreteFlyingEdges3D, midpoint triangles, and then either, within
  0.1 voxels, which merges what is coplanar.
OpenVDB: volumeToMesh with adaptivity 0.1 on a grid of -1 (on) and 1; the time of making the grid is
  left out, the border is closed. A quadrilateral counts as two triangles.
SurfaceNets3D: VTK's, from 9.3 on, without smoothing; triangles between the cells, nothing merged.
plain pass, vector pass: the maximum of all samples at -O2, and all or-ed together at -O3.

Samples are in memory, borders open, one thread; medians of processor time, in turns; memory that is
freed is used again, without page faults.
)";

struct Options {
  bool is_short = false;
  std::optional<std::filesystem::path> folder;
};

std::optional<Options> parsed(const std::vector<std::string_view>& arguments) {
  Options options;
  for (const std::string_view argument : arguments) {
    if (argument == "--short")
      options.is_short = true;
    else if (!options.folder && argument.substr(0, 1) != "-")
      options.folder = argument;
    else
      return std::nullopt;
  }
  return options;
}

std::vector<Contender> surface_contenders(const Volume& volume, bool is_short) {
  std::vector<Contender> contenders = discmc_contenders(volume);
  contenders.push_back(flying_edges(volume));
  if (is_short) return contenders;
  contenders.push_back(decimated(volume));
  contenders.push_back(simplified(volume));
  contenders.push_back(adaptive(volume));
  if (const auto nets = surface_nets(volume)) contenders.push_back(*nets);
  return contenders;
}

std::vector<Contender> empty_contenders(const Volume& volume) {
  return {plain_pass(volume), vector_pass(volume), discmc_contenders(volume)[counting],
          flying_edges(volume)};
}

Measurement measured(const Volume& volume, bool is_generated,
                     const std::vector<Contender>& contenders) {
  std::fprintf(stderr, "bench: %s\n", volume.name.c_str());
  return {volume.name, volume.voxels(), active_cells(volume), is_generated, measure(contenders)};
}

void run(const Options& options) {
  settle();
  std::vector<Measurement> surfaces, empties;
  for (const Volume& volume : {ball(256), gyroid(128), smooth_noise(128), checkerboard(64)})
    surfaces.push_back(measured(volume, true, surface_contenders(volume, options.is_short)));
  for (const Volume& volume : {empty<uint8_t>(256), empty<uint16_t>(256)})
    empties.push_back(measured(volume, true, empty_contenders(volume)));
  if (options.folder)
    for (const Volume& volume : volumes_in(*options.folder))
      surfaces.push_back(measured(volume, false, surface_contenders(volume, options.is_short)));

  std::printf("%s\n%s", versions().c_str(), notes);
  print_surfaces(surfaces);
  print_empty(empties);
}

}  // namespace

}  // namespace discmc::bench

int main(int argc, char** argv) {
  using namespace discmc::bench;
  const auto options = parsed({argv + (argc > 0 ? 1 : 0), argv + argc});
  if (!options) {
    std::fputs(usage, stderr);
    return 2;
  }
  try {
    run(*options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
