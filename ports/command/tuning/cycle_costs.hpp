// The cycles of a device's work. They are estimates; no processor was measured.
#pragma once

#include <cstdint>

namespace discmc::command {

/// The contents of a stream.
enum class Wire { regions, slices };

struct DeviceWork {
  std::uint64_t voxels = 0;  ///< compared with the threshold
  std::uint64_t on = 0;      ///< voxels that are on
  std::uint64_t rows = 0;
  std::uint64_t cells = 0;  ///< through which the surface passes
  std::uint64_t steps = 0;  ///< for regions, the links of rings and loose pieces; for slices, the
                            ///< coded voxels and runs
  std::uint64_t bytes = 0;  ///< of the stream

  DeviceWork operator-(const DeviceWork& before) const {
    return {voxels - before.voxels, on - before.on,       rows - before.rows,
            cells - before.cells,   steps - before.steps, bytes - before.bytes};
  }
};

/// The processors with measured costs. scripts/check/cycles measures the library compiled with -Os,
/// writes these costs, and prints their errors (lib/FOOTPRINT.md).
enum class Core { cortex_m0plus, cortex_m4, cortex_m7 };

/// Processor cycles per unit of DeviceWork.
struct CycleCosts {
  double voxel_of_8_bits, voxel_of_16_bits;
  double on;  ///< extra cost of a voxel that is on
  double row, cell, step, byte;
};

const CycleCosts& cycle_costs(Core core, Wire wire);

/// Units: processor cycles. sample_bytes: 1 or 2.
double cycles_of(const DeviceWork& work, std::uint32_t sample_bytes, const CycleCosts& costs);

}  // namespace discmc::command
