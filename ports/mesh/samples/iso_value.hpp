// The value of a threshold among stored samples.
#ifndef DISCMC_MESH_SAMPLES_ISO_VALUE_HPP
#define DISCMC_MESH_SAMPLES_ISO_VALUE_HPP

#include <cstdint>

#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// The iso value, less what decimal numbers may have lost when they were rounded on their way here:
/// what is not below this reaches iso.
double lowered_by_rounding(const SampleGrid& info, double iso);

/// The threshold on stored samples for an iso value in the file's declared units: stored >=
/// threshold exactly where value >= iso. Values equal iso if they differ by no more than the
/// rounding of the decimal numbers. So iso 0.9 at slope 0.3 is 3, not 4. Saturates: INT32_MIN
/// when every value reaches iso, INT32_MAX when none does (or iso is NaN). For samples that are not
/// whole numbers it is the first whole one.
std::int32_t stored_threshold(const SampleGrid& info, double iso);

}  // namespace discmc::meshing

#endif
