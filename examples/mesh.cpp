#include <cstdio>
#include <discmc/mesh.hpp>

int main() {
  std::vector<float> samples(64 * 64 * 64);  // your array: x runs fastest, then y, then z
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = float(i % 64 * (i / 64 % 64));
  const discmc::Mesh mesh = discmc::mesh_of(samples, {64, 64, 64}, 500);
  for (const auto& [x, y, z] : mesh.vertices) std::printf("v %g %g %g\n", x, y, z);
  for (const auto& [a, b, c] : mesh.triangles) std::printf("f %u %u %u\n", a + 1, b + 1, c + 1);
}
