// Triangles made less thin by flips of their edges.
#ifndef DISCMC_COMMAND_MESHES_EDGE_FLIPS_HPP
#define DISCMC_COMMAND_MESHES_EDGE_FLIPS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "point.hpp"

namespace discmc::command {

/// Flips the edge between two triangles if the least of their angles becomes larger, until there is
/// no such edge. The surface moves by at most a small part of the edge. No edge is made twice.
/// corners: three vertex numbers per triangle. first: the triangles before this stay.
void flip_edges(const std::vector<Point>& vertices, std::vector<std::uint32_t>& corners,
                std::size_t first);

}  // namespace discmc::command

#endif
