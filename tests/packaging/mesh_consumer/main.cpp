// One voxel in the middle of a volume: its surface is an octahedron.
#include <discmc/mesh.hpp>

int main() {
  std::vector<float> volume(27);
  volume[13] = 1;
  const discmc::Mesh mesh = discmc::mesh_of(volume, {3, 3, 3}, 0.5);
  const discmc::MeshMeasures measures = discmc::measures_of(mesh);
  try {
    (void)discmc::mesh_of(volume, {3, 3, 4}, 0.5);
    return 1;
  } catch (const std::invalid_argument&) {
  }
  return mesh.triangles.size() == 8 && measures.is_closed && measures.bodies == 1 ? 0 : 2;
}
