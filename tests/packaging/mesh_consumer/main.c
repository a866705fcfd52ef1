/* One voxel in the middle of a volume: its surface is an octahedron. */
#include <discmc/mesh.h>

#include <math.h>

int main(void) {
  static const uint8_t volume[27] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  const discmc_samples samples = {volume, DISCMC_SAMPLES_U8, {3, 3, 3}, {0, 0, 0}};
  discmc_mesh mesh;
  size_t triangles;
  if (discmc_mesh_of(&samples, 1, INFINITY, NULL, &mesh) != DISCMC_MESH_OK) return 1;
  triangles = mesh.triangle_count;
  discmc_mesh_free(&mesh);
  if (discmc_mesh_of(&samples, 2, 1, NULL, &mesh) != DISCMC_MESH_BAD_ARGUMENT) return 2;
  return triangles == 8 && mesh.message[0] != '\0' ? 0 : 3;
}
