// The mesh of a large array by several threads, with progress; Ctrl-C cancels it.
//
//   mesh_threads [EXTENT [THREADS]]     by default 256 voxels per axis, and all processors
//
//   505984 triangles, closed, volume 8386907, 0.22 s
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <discmc/mesh.hpp>

namespace {

volatile std::sig_atomic_t is_interrupted = 0;

// A gyroid with a period of 64 voxels: 0 on its surface.
std::vector<float> gyroid(std::size_t extent) {
  std::vector<float> sine, cosine, samples;
  for (std::size_t i = 0; i < extent; ++i) {
    sine.push_back(std::sin(float(i) * 0.0981748F));
    cosine.push_back(std::cos(float(i) * 0.0981748F));
  }
  for (std::size_t z = 0; z < extent; ++z)
    for (std::size_t y = 0; y < extent; ++y)
      for (std::size_t x = 0; x < extent; ++x)
        samples.push_back(sine[x] * cosine[y] + sine[y] * cosine[z] + sine[z] * cosine[x]);
  return samples;
}

}  // namespace

int main(int count, char** arguments) {
  const std::size_t extent = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 256;
  std::signal(SIGINT, [](int) { is_interrupted = 1; });

  discmc::MeshOptions options;
  options.threads = count > 2 ? unsigned(std::atoi(arguments[2])) : 0;  // 0: all processors
  options.progress = [](const discmc::MeshProgress& at) {
    if (at.all > 0)
      std::fprintf(stderr, "\r%s %3.0f %%", at.step, 100. * double(at.done) / double(at.all));
    return !is_interrupted;
  };
  try {
    const std::vector<float> samples = gyroid(extent);
    const auto begin = std::chrono::steady_clock::now();
    const discmc::Mesh mesh = discmc::mesh_of(samples, {extent, extent, extent}, 0, options);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const discmc::MeshMeasures measures = discmc::measures_of(mesh);
    std::printf("\n%zu triangles, %s, volume %.0f, %.2f s\n", mesh.triangles.size(),
                measures.is_closed ? "closed" : "open", measures.volume, seconds.count());
  } catch (const discmc::Cancelled&) {
    std::puts("\ncancelled");
    return 1;
  } catch (const std::exception& error) {  // names the value and the remedy
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
