/* Meshes of volumes for C99, and for every language that calls C: the triangles of an array.
 *
 *   const discmc_samples samples = {volume, DISCMC_SAMPLES_U16, {nx, ny, nz}, {0, 0, 0}};
 *   discmc_mesh mesh;
 *   if (discmc_mesh_of(&samples, 500, INFINITY, NULL, &mesh) != DISCMC_MESH_OK)
 *     fprintf(stderr, "%s\n", mesh.message);
 *   for (size_t i = 0; i < 3 * mesh.triangle_count; ++i)
 *     use(&mesh.vertices[3 * mesh.triangles[i]]);
 *   discmc_mesh_free(&mesh);
 *
 * A voxel is inside if its sample is >= level_low and <= level_high. The mesh is closed, without
 * T-junctions, and its triangles are counter-clockwise seen from outside. By default vertices lie
 * halfway between voxels, and coplanar facets are merged before they are triangulated.
 *
 * Options and descriptions whose members are zero have the defaults. Pointers must not be null
 * unless a comment allows it. Owner: the caller owns samples and options, and may free them after
 * the call. Calls share nothing: any thread may make one at any time. Link the C++ run-time
 * library, for example by linking with the C++ compiler. In C++: discmc/mesh.hpp. */
#ifndef DISCMC_MESH_H
#define DISCMC_MESH_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- in ---- */
enum {
  DISCMC_SAMPLES_U8,
  DISCMC_SAMPLES_I8,
  DISCMC_SAMPLES_U16,
  DISCMC_SAMPLES_I16,
  DISCMC_SAMPLES_U32,
  DISCMC_SAMPLES_I32,
  DISCMC_SAMPLES_U64,
  DISCMC_SAMPLES_I64,
  DISCMC_SAMPLES_F32,
  DISCMC_SAMPLES_F64
};

/* An array in memory, which is never copied. A sample that is not a number is outside. */
typedef struct discmc_samples {
  const void* data;     /* of voxel (0, 0, 0), at the natural alignment of the type */
  int32_t type;         /* DISCMC_SAMPLES_... */
  int64_t extents[3];   /* voxels along x, y, z. Limit: two of them 32766, the third 2^30 - 1 */
  ptrdiff_t strides[3]; /* distances along x, y, z, also negative. Units: samples. All 0: sample
                           (x, y, z) is data[x + extents[0] * (y + extents[1] * z)] */
} discmc_samples;

enum {
  DISCMC_NORMALS_NONE,
  DISCMC_NORMALS_SURFACE, /* of the polygons around a vertex */
  DISCMC_NORMALS_GRADIENT /* of the samples. Limit: a level_high of infinity, no smoothing */
};

typedef struct discmc_mesh_options {
  /* Distances between voxels along x, y, z, in any unit, which is that of the mesh; negative if the
   * axis runs backwards. All 0: 1, 1, 1. Limit: 1e-6 to 1e6. */
  double spacing[3];
  /* Null, or 3 rows of 4 numbers instead of the spacing. Row r of voxel (i, j, k) is column 3 plus
   * i, j, k times columns 0 to 2. */
  const double* placement;
  int32_t has_open_border; /* 0: the surface closes at the border of the array; 1: it ends there */
  int32_t interpolates;    /* 1: vertices lie where the samples cross the level */
  int32_t relaxes;         /* 1: vertices move between the voxels to the smoothest surface that
                              keeps every voxel on its side. Limit: not interpolated, no labels */
  double tolerance;        /* of interpolation and relaxation. Units: voxels. 0: 0.05 */
  double smoothing;        /* the deviation of a Gaussian that smooths a mask or a label. 0: none.
                              Units: as spacing */
  uint64_t triangles;      /* decimates to this many triangles, or as far as the meshes stay */
  double max_error;        /* within max_error, whichever comes first. 0: not. Units: as spacing */
  int32_t normals;         /* DISCMC_NORMALS_... */
  int32_t polygons;        /* 1: also the polygons. Limit: not interpolated, relaxed, decimated */
  int32_t threads;         /* 0 or 1: one; -1: as many as there are processors */
  /* Null, or called in the calling thread with user. Return 0 to cancel the call. done and all
   * count slices; all is 0 if the step does not count. */
  int32_t (*progress)(void* user, const char* step, uint64_t done, uint64_t all);
  void* user;
} discmc_mesh_options;

/* ---- out ---- */
enum {
  DISCMC_MESH_OK,
  DISCMC_MESH_BAD_ARGUMENT, /* the message names the value and the remedy */
  DISCMC_MESH_TOO_LARGE,    /* more than 2^32 corners */
  DISCMC_MESH_NO_MEMORY,
  DISCMC_MESH_CANCELLED, /* progress returned 0 */
  DISCMC_MESH_FAILED     /* any other exception, with its text in the message */
};

/* Owner of the arrays: the mesh, until it is freed. */
typedef struct discmc_mesh {
  size_t vertex_count;
  const double* vertices; /* 3 per vertex. Units: those of the spacing */
  const double* normals; /* 3 per vertex: unit vectors, outwards, or zeros; null unless asked for */
  size_t triangle_count;
  const uint32_t* triangles; /* 3 vertex numbers per triangle */
  /* Merged polygons; none unless asked for. Polygon p has the rings from ring_begin[p] to before
   * ring_begin[p + 1]: the outer ring, then its holes. Ring r has the corners from corner_begin[r]
   * to before corner_begin[r + 1], the outer ring counter-clockwise seen from outside, holes
   * clockwise. */
  size_t polygon_count;
  const size_t* ring_begin;
  const size_t* corner_begin;
  const uint32_t* corners;       /* vertex numbers */
  const double* polygon_normals; /* 3 per polygon */
  char message[256];             /* of an error; empty otherwise */
  void* owner;
} discmc_mesh;

/* The surface of a level. options: may be null. Returns DISCMC_MESH_OK or an error, after which the
 * mesh has a message and no arrays, and need not be freed. */
int32_t discmc_mesh_of(const discmc_samples* samples, double level_low, double level_high,
                       const discmc_mesh_options* options, discmc_mesh* mesh);

/* Frees the arrays. Any number of times, if the mesh was zeroed or is of a call; mesh: may be null.
 */
void discmc_mesh_free(discmc_mesh* mesh);

/* The surface of the voxels of one value. */
typedef struct discmc_label_mesh {
  int64_t label;
  uint64_t voxels;
  discmc_mesh mesh; /* Owner: discmc_label_meshes */
} discmc_label_mesh;

typedef struct discmc_label_meshes {
  size_t count;
  const discmc_label_mesh* meshes; /* the least label first */
  char message[256];               /* of an error; empty otherwise */
  void* owner;
} discmc_label_meshes;

/* The surfaces of all labels but 0 in one pass, or only of those given; labels: may be null if the
 * count is 0. Neighbours share their walls exactly. Limit: samples of whole numbers, at most 65,536
 * labels; no gradient normals, and interpolates only with smoothing. Returns and errors: as
 * discmc_mesh_of(). */
int32_t discmc_label_meshes_of(const discmc_samples* samples, const int64_t* labels,
                               size_t label_count, const discmc_mesh_options* options,
                               discmc_label_meshes* meshes);

void discmc_label_meshes_free(discmc_label_meshes* meshes);

#ifdef __cplusplus
}
#endif

#endif
