// The ways to make a surface that are compared.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "volumes.hpp"

namespace discmc::bench {

/// A program and its settings, with a volume in the form that it reads. Unless noted, it runs on
/// one thread and leaves the border open.
struct Contender {
  std::string name;
  std::string unit;  ///< of what run() returns
  /// Makes the surface once, from samples in memory, and returns how much came out.
  std::function<uint64_t()> run;
};

/// discmc with a sink that counts regions, one that keeps polygons, and the encoder. From start()
/// on, with so much memory that nothing goes out loose. Limit: the volume outlives them, here and
/// below.
std::vector<Contender> discmc_contenders(const Volume& volume);

/// VTK's FlyingEdges3D: interpolated triangles that share vertices, without normals or scalars.
Contender flying_edges(const Volume& volume);

/// VTK's DiscreteFlyingEdges3D, whose vertices are in the middle of edges as discmc's are. Then
/// DecimatePro merges all within 0.1 voxels of a plane: here, coplanar triangles.
Contender decimated(const Volume& volume);

/// The same triangles simplified by meshoptimizer, with the same tolerance.
Contender simplified(const Volume& volume);

/// VTK's SurfaceNets3D without smoothing, from VTK 9.3 on: none before.
std::optional<Contender> surface_nets(const Volume& volume);

/// OpenVDB's volumeToMesh with adaptivity 0.1, on a grid of -1 for voxels that are on, else 1,
/// which is there already. It merges what turns by less than 26 degrees. Its border is closed.
Contender adaptive(const Volume& volume);

/// The maximum of the samples, by a loop compiled with -O2: each is looked at by itself.
Contender plain_pass(const Volume& volume);

/// The samples or-ed together, which the compiler does in vectors: the least that can be done with
/// all of them.
Contender vector_pass(const Volume& volume);

/// While it exists, all contenders work on one thread, and the process keeps memory that is freed.
/// So the time is their own, without the page faults of their results.
void settle();

/// The versions of the linked libraries, as a part of a sentence.
std::string versions();

}  // namespace discmc::bench
