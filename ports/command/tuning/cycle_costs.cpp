#include "cycle_costs.hpp"

namespace discmc::command {
namespace {

// scripts/check/cycles writes the lines between the marks.
// clang-format off
constexpr CycleCosts all_costs[][2] = {
    // begin
    {{1.047, 3.774, 19.54, 1103, 380.8, 837.7, 1888},
     {5.994, 8.193, 19.54, 1811, 0, 276.7, 493.9}},
    {{1.213, 2.413, 10.86, 870.3, 234.8, 640.6, 1666},
     {4.634, 5.58, 10.86, 1364, 0, 199.5, 461.3}},
    {{0.6281, 1.292, 7.993, 525.8, 149.4, 400.5, 973.8},
     {2.742, 3.266, 7.993, 795.7, 0, 111.6, 295.7}},
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
