#include "cycle_costs.hpp"

namespace discmc::command {
namespace {

// scripts/check/cycles writes the lines between the marks.
// clang-format off
constexpr CycleCosts all_costs[][2] = {
    // begin
    {{1.069, 3.8, 19.66, 1114, 382.5, 782.4, 2570},
     {5.993, 8.193, 19.66, 1811, 0, 276.1, 498.6}},
    {{1.23, 2.429, 10.91, 871, 235.4, 605.8, 2209},
     {4.635, 5.58, 10.91, 1364, 0, 199.2, 463.3}},
    {{0.6362, 1.3, 8.001, 524.9, 151.9, 373.9, 1258},
     {2.674, 3.199, 8.001, 796.3, 0, 110, 292.6}},
    // end
};
// clang-format on

}  // namespace

const CycleCosts& cycle_costs(Core core, Payload payload) {
  return all_costs[static_cast<int>(core)][static_cast<int>(payload)];
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
