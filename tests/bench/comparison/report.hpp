// Prints measurements as tables in Markdown.
#pragma once

#include <vector>

#include "measure.hpp"

namespace discmc::bench {

/// The row of a contender in the table of a surface; simplifiers are last.
enum Place : size_t { counting, polygons, stream, flying_edges_3d, first_simplifier };

/// The row of a contender in the table of an empty volume.
enum PlaceOfEmpty : size_t { empty_plain_pass, empty_vector_pass, empty_counting };

/// Nanoseconds per active cell, the other contenders' times relative to discmc with geometric
/// means, and the sizes of the results.
void print_surfaces(const std::vector<Measurement>& measurements);

/// Empty volumes: nanoseconds per voxel, and discmc's time relative to a pass over the samples.
void print_empty(const std::vector<Measurement>& measurements);

}  // namespace discmc::bench
