// The compared ways to make a surface.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "volumes.hpp"

namespace discmc::bench {

/// A program and its settings, with a volume in the program's own form. Unless noted, it runs on
/// one thread and leaves the border open.
struct Contender {
  std::string name;
  std::string unit;  ///< of what run() returns
  /// Makes the surface once, from samples in memory, and returns the size of the result.
  std::function<uint64_t()> run;
};

/// discmc with a sink that counts regions, with a sink that keeps polygons, and with the encoder.
/// Measured from start() on, with enough memory for whole regions. Limit, here and below: the
/// volume outlives the contenders.
std::vector<Contender> discmc_contenders(const Volume& volume);

/// VTK's FlyingEdges3D: interpolated triangles with shared vertices, without normals or scalars.
Contender flying_edges(const Volume& volume);

/// VTK's DiscreteFlyingEdges3D, whose vertices are in the middle of edges like discmc's. Then
/// DecimatePro merges triangles within 0.1 voxels of a plane, here coplanar ones.
Contender decimated(const Volume& volume);

/// The same triangles simplified by meshoptimizer, with the same tolerance.
Contender simplified(const Volume& volume);

/// VTK's SurfaceNets3D without smoothing, from VTK 9.3 on; before, none.
std::optional<Contender> surface_nets(const Volume& volume);

/// OpenVDB's volumeToMesh with adaptivity 0.1, on an existing grid: -1 for on voxels, else 1. It
/// merges facets whose normals differ by less than 26 degrees. Its border is closed.
Contender adaptive(const Volume& volume);

/// The maximum of the samples, by a loop compiled with -O2 without vectors.
Contender plain_pass(const Volume& volume);

/// A bitwise OR of all samples, vectorised by the compiler: the minimum time to read all samples.
Contender vector_pass(const Volume& volume);

/// During its lifetime, all contenders use one thread, and the process keeps freed memory. So times
/// exclude page faults of results.
void settle();

/// The versions of the linked libraries, as a phrase.
std::string versions();

}  // namespace discmc::bench
