// The cycles of a device's work: an estimate, as no processor was measured.
#pragma once

#include <cstdint>

namespace discmc::command {

/// What a stream holds.
enum class Wire { regions, slices };

struct DeviceWork {
  std::uint64_t voxels = 0;  ///< compared with the threshold
  std::uint64_t on = 0;      ///< of them
  std::uint64_t rows = 0;
  std::uint64_t cells = 0;  ///< that the surface passes through
  std::uint64_t steps = 0;  ///< of regions the links of rings and loose pieces; of slices the
                            ///< voxels and runs that are coded
  std::uint64_t bytes = 0;  ///< of the stream

  DeviceWork operator-(const DeviceWork& before) const {
    return {voxels - before.voxels, on - before.on,       rows - before.rows,
            cells - before.cells,   steps - before.steps, bytes - before.bytes};
  }
};

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
