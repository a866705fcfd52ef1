// Runs the command discmc and vtk_mesh alternately, from raw volumes to STL and PLY files. Prints
// their processor time on one thread, their time on two threads, and their peak memory.
// scripts/tools/bench-command builds and runs it.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
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
  double processor_seconds;
  double elapsed_seconds;
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
  const auto begin = std::chrono::steady_clock::now();
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
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

// Each figure is a median of its own.
Cost median(std::vector<Cost> costs) {
  const auto middle = [&costs](double Cost::*figure) {
    const auto at = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
    std::nth_element(costs.begin(), at, costs.end(),
                     [=](const Cost& a, const Cost& b) { return a.*figure < b.*figure; });
    return *at.*figure;
  };
  return {middle(&Cost::processor_seconds), middle(&Cost::elapsed_seconds),
          middle(&Cost::mebibytes)};
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

// Returns the compared time: processor time for one thread, wall time for several.
double seconds_of(const Cost& cost, int threads) {
  return threads == 1 ? cost.processor_seconds : cost.elapsed_seconds;
}

// With files of this extension.
void compare(int threads, const std::string& discmc, const std::string& vtk,
             const DescribedVolume& volume, const std::filesystem::path& folder,
             const std::string& format, Ratios& ratios) {
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
                            std::to_string(threads),
                            "-q",
                            "-o",
                            output};
    Arguments theirs = {vtk, raw, type};
    theirs.insert(theirs.end(), dims.begin(), dims.end());
    theirs.insert(theirs.end(), spacing.begin(), spacing.end());
    // Between the samples, so that the same voxels are on.
    theirs.insert(theirs.end(), {text_of(threshold - 0.5), output, std::to_string(threads)});
    std::vector<Cost> our_costs, their_costs;
    for (int round = 0; round < rounds; ++round) {
      our_costs.push_back(run(ours));
      their_costs.push_back(run(theirs));
    }
    const Cost a = median(our_costs), b = median(their_costs);
    const double our_seconds = seconds_of(a, threads), their_seconds = seconds_of(b, threads);
    ratios.push_back(their_seconds / our_seconds);
    std::printf("| %s at %d, .%s | %.3f | %.3f | %.2f | %.0f | %.0f | %.2f |\n",
                volume.file.stem().stem().string().c_str(), threshold, format.c_str(), our_seconds,
                their_seconds, ratios.back(), a.mebibytes, b.mebibytes, b.mebibytes / a.mebibytes);
    std::fflush(stdout);
  }
}

void print_summary(const Ratios& ratios) {
  if (ratios.empty()) return;
  double logs = 0;
  for (const double ratio : ratios) logs += std::log(ratio);
  std::printf("\nVTK takes %.2f times as long (geometric mean), at least %.2f.\n\n",
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
    for (const int threads : {1, 2}) {
      std::printf("Seconds %s:\n\n", threads == 1 ? "of one core" : "on a clock, with two threads");
      std::puts("| volume | discmc, s | VTK, s | VTK / discmc | discmc, MiB | VTK, MiB | ratio |");
      std::puts("|---|--:|--:|--:|--:|--:|--:|");
      Ratios ratios;
      for (const DescribedVolume& volume : discmc::command::described_volumes(argv[3]))
        for (const char* format : {"stl", "ply"})
          compare(threads, argv[1], argv[2], volume, argv[4], format, ratios);
      print_summary(ratios);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_command: %s\n", error.what());
    return 1;
  }
  return 0;
}
