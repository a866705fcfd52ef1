// Shared by the tests of the device ports: a volume in rows, and its stream without a device.
#pragma once

#include <common/row_scan.hpp>
#include <gpio/row_source.hpp>
#include <set>

#include "oracle/stream.hpp"

namespace discmc::test {

inline device::ScanPlan plan_of(std::uint32_t width, std::uint32_t height, std::uint32_t depth,
                                meshing::SampleType type = meshing::SampleType::u8) {
  device::ScanPlan plan;
  plan.dims = {width, height, depth};
  plan.type = type;
  plan.threshold = 130;
  plan.memory = 256 * 1024;
  return plan;
}

/// The rows of a simulated volume.
inline std::vector<Bytes> rows_of(const device::ScanPlan& plan) {
  const auto source = device::simulated_rows(plan.dims, plan.type);
  std::vector<Bytes> rows(plan.rows(), Bytes(plan.row_bytes()));
  for (std::uint32_t i = 0; i < plan.rows(); ++i) source->read(i, rows[i]);
  return rows;
}

/// The stream of 8-bit samples that ends after some rows, with some of them skipped.
inline Bytes expected_stream(const device::ScanPlan& plan, std::uint32_t row_count,
                             const std::set<std::uint32_t>& skipped = {}) {
  const std::vector<Bytes> rows = rows_of(plan);
  const auto& dims = plan.dims;
  Bytes memory(plan.memory);
  Line line(0);
  Encoder encoder;
  Extractor16 extractor;
  reference::require_ok(encoder.start({dims[2], {1000000, 1000000, 1000000}}, line.output()));
  reference::require_ok(extractor.start({dims[0], dims[1]}, plan.threshold,
                                        {memory.data(), memory.size()}, make_sink(encoder)));
  for (std::uint32_t i = 0; i < row_count; ++i)
    reference::require_ok(skipped.count(i) > 0 ? extractor.skip_row(Substitute::previous_row).status
                                               : extractor.push(rows[i].data(), dims[0]).status);
  reference::require_ok(row_count % dims[1] == 0 ? extractor.finish() : extractor.abandon());
  return line.bytes;
}

/// A scan that keeps its stream.
struct Recording {
  explicit Recording(const device::ScanPlan& plan) : scan(plan, line.output()) {}
  Line line{0};
  device::RowScan scan;
};

}  // namespace discmc::test
