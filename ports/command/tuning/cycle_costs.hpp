// The cycles of a device's work: an estimate, as no processor was measured.
#ifndef DISCMC_COMMAND_TUNING_CYCLE_COSTS_HPP
#define DISCMC_COMMAND_TUNING_CYCLE_COSTS_HPP

#include <cstdint>

#include "device_work.hpp"
#include "streams/wire_kind.hpp"

namespace discmc::command {

/// The costs of the library compiled with -Os. scripts/check/cycles measures and writes them, and
/// prints their errors (lib/FOOTPRINT.md).
enum class Core { cortex_m0plus, cortex_m4, cortex_m7 };

/// Units: processor cycles, for each unit of DeviceWork.
struct CycleCosts {
  double voxel_of_8_bits, voxel_of_16_bits;
  double on;  ///< more for a voxel that is on
  double row, cell, step, byte;
};

const CycleCosts& cycle_costs(Core core, Wire wire);

/// Units: processor cycles. sample_bytes: 1 or 2.
double cycles_of(const DeviceWork& work, std::uint32_t sample_bytes, const CycleCosts& costs);

}  // namespace discmc::command

#endif
