// What a device does for a scan, in the units that cycle_costs.hpp has prices of.
#ifndef DISCMC_COMMAND_TUNING_DEVICE_WORK_HPP
#define DISCMC_COMMAND_TUNING_DEVICE_WORK_HPP

#include <cstdint>

namespace discmc::command {

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

}  // namespace discmc::command

#endif
