// What was measured, as tables in Markdown.
#pragma once

#include <vector>

#include "measure.hpp"

namespace discmc::bench {

/// The row of a contender in the table of a surface; simplifiers are last.
enum Place : size_t { counting, polygons, stream, flying_edges_3d, first_simplifier };

/// The row of a contender in the table of an empty volume.
enum PlaceOfEmpty : size_t { empty_plain_pass, empty_vector_pass, empty_counting };

/// Nanoseconds an active cell; how many times as long the others take, with geometric means; and
/// what came out.
void print_surfaces(const std::vector<Measurement>& measurements);

/// Empty volumes: nanoseconds a voxel, and how many times as long as a pass discmc takes.
void print_empty(const std::vector<Measurement>& measurements);

}  // namespace discmc::bench
