/* The triangles of an array in C, as a Wavefront file: mesh > corner.obj. */
#include <discmc/mesh.h>
#include <math.h>
#include <stdio.h>

static float samples[64 * 64 * 64]; /* x runs fastest, then y, then z */

int main(void) {
  const discmc_samples volume = {samples, DISCMC_SAMPLES_F32, {64, 64, 64}, {0, 0, 0}};
  discmc_mesh_options options = {0}; /* the defaults */
  discmc_mesh mesh;
  size_t i;
  for (i = 0; i < 64 * 64 * 64; ++i) samples[i] = (float)(i % 64 * (i / 64 % 64));
  options.interpolates = 1;
  if (discmc_mesh_of(&volume, 500, INFINITY, &options, &mesh) != DISCMC_MESH_OK) {
    fprintf(stderr, "%s\n", mesh.message);
    return 1;
  }
  for (i = 0; i < 3 * mesh.vertex_count; i += 3)
    printf("v %g %g %g\n", mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]);
  for (i = 0; i < 3 * mesh.triangle_count; i += 3)
    printf("f %u %u %u\n", mesh.triangles[i] + 1, mesh.triangles[i + 1] + 1,
           mesh.triangles[i + 2] + 1);
  discmc_mesh_free(&mesh);
  return 0;
}
