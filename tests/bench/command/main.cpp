// Runs the command discmc and vtk_mesh alternately, from raw volumes to STL and PLY files. Prints
// their processor time and peak memory side by side. scripts/tools/bench-command builds and runs
// it.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/described_volumes.hpp"
#include "volumes/volume.hpp"

namespace {

using discmc::command::DescribedVolume;
using discmc::command::VolumeInfo;
using Arguments = std::vector<std::string>;

constexpr int rounds = 5;

struct Cost {
  double seconds;  // of processor time
  double mebibytes;
};

std::string text_of(double number) {
  std::ostringstream text;
  text.precision(9);
  text << number;
  return text.str();
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

Cost run(const Arguments& arguments) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.data()));
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execv(words[0], words.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0)
    throw std::runtime_error(arguments[0] + " failed");
  return {seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

Cost median(std::vector<Cost> costs) {
  std::sort(costs.begin(), costs.end(),
            [](const Cost& a, const Cost& b) { return a.seconds < b.seconds; });
  return costs[costs.size() / 2];
}

VolumeInfo write_raw(const std::filesystem::path& volume, const std::filesystem::path& raw) {
  const auto reader = discmc::command::open_volume(volume);
  const VolumeInfo info = reader->info();
  std::vector<char> slice(info.slice_bytes());
  std::ofstream file(raw, std::ios::binary);
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    reader->read_slice(slice.data());
    file.write(slice.data(), static_cast<std::streamsize>(slice.size()));
  }
  if (!file.flush()) throw std::runtime_error(raw.string() + ": writing failed");
  return info;
}

std::string joined(const Arguments& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

// Returns VTK's time divided by that of discmc.
using Ratios = std::vector<double>;

// With files of this extension.
void compare(const std::string& discmc, const std::string& vtk, const DescribedVolume& volume,
             const std::filesystem::path& folder, const std::string& format, Ratios& ratios) {
  const std::string raw = (folder / "volume.raw").string();
  const std::string output = (folder / ("surface." + format)).string();
  const VolumeInfo info = write_raw(volume.file, raw);
  const std::string type(name(info.type));
  Arguments dims, spacing;
  for (const std::uint32_t extent : info.dims) dims.push_back(std::to_string(extent));
  for (const double step : info.spacing_mm) spacing.push_back(text_of(step));
  for (const std::int32_t threshold : volume.thresholds) {
    const Arguments ours = {discmc,
                            "extract",
                            raw,
                            "--dims",
                            joined(dims),
                            "--type",
                            type,
                            "--spacing",
                            joined(spacing),
                            "--iso",
                            std::to_string(threshold),
                            "--jobs",
                            "1",
                            "-q",
                            "-o",
                            output};
    Arguments theirs = {vtk, raw, type};
    theirs.insert(theirs.end(), dims.begin(), dims.end());
    theirs.insert(theirs.end(), spacing.begin(), spacing.end());
    // Between the samples, so that the same voxels are on.
    theirs.insert(theirs.end(), {text_of(threshold - 0.5), output});
    std::vector<Cost> our_costs, their_costs;
    for (int round = 0; round < rounds; ++round) {
      our_costs.push_back(run(ours));
      their_costs.push_back(run(theirs));
    }
    const Cost a = median(our_costs), b = median(their_costs);
    ratios.push_back(b.seconds / a.seconds);
    std::printf("| %s at %d, .%s | %.3f | %.3f | %.2f | %.0f | %.0f | %.2f |\n",
                volume.file.stem().stem().string().c_str(), threshold, format.c_str(), a.seconds,
                b.seconds, ratios.back(), a.mebibytes, b.mebibytes, b.mebibytes / a.mebibytes);
    std::fflush(stdout);
  }
}

void print_summary(const Ratios& ratios) {
  if (ratios.empty()) return;
  double logs = 0;
  for (const double ratio : ratios) logs += std::log(ratio);
  std::printf("\nVTK takes %.2f times as long (geometric mean), at least %.2f.\n",
              std::exp(logs / static_cast<double>(ratios.size())),
              *std::min_element(ratios.begin(), ratios.end()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: bench_command DISCMC VTK_MESH VOLUMES SCRATCH\n", stderr);
    return 2;
  }
  try {
    std::puts("| volume | discmc, s | VTK, s | VTK / discmc | discmc, MiB | VTK, MiB | ratio |");
    std::puts("|---|--:|--:|--:|--:|--:|--:|");
    Ratios ratios;
    for (const DescribedVolume& volume : discmc::command::described_volumes(argv[3]))
      for (const char* format : {"stl", "ply"})
        compare(argv[1], argv[2], volume, argv[4], format, ratios);
    print_summary(ratios);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_command: %s\n", error.what());
    return 1;
  }
  return 0;
}
