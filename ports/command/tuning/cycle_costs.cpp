#include "cycle_costs.hpp"

namespace discmc::command {
namespace {

// scripts/check/cycles writes the lines between the marks.
// clang-format off
constexpr CycleCosts all_costs[][2] = {
    // begin
    {{2.681, 6.456, 13.89, 1970, 312.4, 726.3, 2561},
     {5.993, 8.192, 13.89, 1808, 0, 305, 281.5}},
    {{2.706, 4.32, 6.702, 1351, 196.2, 555.2, 2194},
     {4.876, 5.977, 6.702, 1362, 0, 217.8, 318.9}},
    {{1.707, 2.741, 5.453, 792, 125.1, 342.5, 1238},
     {2.983, 3.64, 5.453, 791.9, 0, 122.2, 213.8}},
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
