#include "cycle_costs.hpp"

namespace discmc::host {
namespace {

// scripts/cycles writes the lines between the marks.
constexpr CycleCosts costs[][2] = {
    // begin
    {{6, 7, 100, 1200, 300, 10}, {8, 9, 100, 300, 0, 800}},
    {{6, 7, 100, 1200, 300, 10}, {8, 9, 100, 300, 0, 800}},
    {{6, 7, 100, 1200, 300, 10}, {8, 9, 100, 300, 0, 800}},
    // end
};

}  // namespace

const CycleCosts& cycle_costs(Core core, Payload payload) {
  return costs[static_cast<int>(core)][static_cast<int>(payload)];
}

double cycles_of(const DeviceWork& work, std::uint32_t sample_bytes, const CycleCosts& costs) {
  const auto times = [](std::uint64_t count, double cost) {
    return static_cast<double>(count) * cost;
  };
  const double voxel = sample_bytes == 1 ? costs.voxel_of_8_bits : costs.voxel_of_16_bits;
  return times(work.voxels, voxel) + times(work.rows, costs.row) + times(work.cells, costs.cell) +
         times(work.links, costs.link) + times(work.bytes, costs.byte);
}

}  // namespace discmc::host
