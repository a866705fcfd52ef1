// Converts thresholds to stored samples.
#ifndef DISCMC_MESH_SAMPLES_ISO_VALUE_HPP
#define DISCMC_MESH_SAMPLES_ISO_VALUE_HPP

#include <cstdint>

#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// Returns the iso value, less the possible rounding of its decimal number. Values that are not
/// below this reach iso.
double lowered_by_rounding(const SampleGrid& info, double iso);

/// Returns the threshold on stored samples for an iso value in the file's units: stored >=
/// threshold exactly if value >= iso. Values that differ from iso by the rounding of decimal
/// numbers count as equal, so iso 0.9 at slope 0.3 is 3, not 4. Saturates: INT32_MIN if every value
/// reaches iso, INT32_MAX if none does (or iso is NaN). For fractional samples it is the first
/// whole number.
std::int32_t stored_threshold(const SampleGrid& info, double iso);

}  // namespace discmc::meshing

#endif
