#include "cycle_costs.hpp"

namespace discmc::command {
namespace {

// scripts/check/cycles writes the lines between the marks.
// clang-format off
constexpr CycleCosts all_costs[][2] = {
    // begin
    {{1.046, 3.772, 19.58, 1106, 353.1, 827, 1885},
     {5.268, 7.467, 19.58, 1774, 0, 254, 435.3}},
    {{1.212, 2.411, 10.88, 869.9, 210.8, 623.3, 1668},
     {4.152, 5.098, 10.88, 1293, 0, 158.3, 398}},
    {{0.6275, 1.291, 8.008, 525.6, 129.9, 388.2, 975.8},
     {2.429, 2.953, 8.008, 761.3, 0, 88.89, 261.7}},
    // end
};
// clang-format on

}  // namespace

const CycleCosts& cycle_costs(Core core, Wire wire) {
  return all_costs[static_cast<int>(core)][static_cast<int>(wire)];
}

double cycles_of(const DeviceWork& work, std::uint32_t sample_bytes, const CycleCosts& costs) {
  const auto times = [](std::uint64_t count, double cost) {
    return static_cast<double>(count) * cost;
  };
  const double voxel = sample_bytes == 1 ? costs.voxel_of_8_bits : costs.voxel_of_16_bits;
  return times(work.voxels, voxel) + times(work.on, costs.on) + times(work.rows, costs.row) +
         times(work.cells, costs.cell) + times(work.steps, costs.step) +
         times(work.bytes, costs.byte);
}

}  // namespace discmc::command
