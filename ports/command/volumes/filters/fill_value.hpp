// Samples that are declared to be none.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_FILL_VALUE_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_FILL_VALUE_HPP

#include <memory>

#include "volumes/volume_reader.hpp"

namespace discmc::command {

/// The values of a volume as floating point, NaN where a sample is the fill value: NaN is outside
/// every surface. fill: as stored.
std::unique_ptr<VolumeReader> without_fill(std::unique_ptr<VolumeReader> volume, double fill);

}  // namespace discmc::command

#endif
