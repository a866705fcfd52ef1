#include "device_scan.hpp"

#include <algorithm>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/slice_encoder.hpp>

#include "extraction/arena_memory.hpp"
#include "require.hpp"

namespace discmc::web {
namespace {

ByteOutput output_to(std::vector<std::uint8_t>& stream) {
  return {&stream, [](void* context, const std::uint8_t* bytes, std::size_t count) {
            auto& all = *static_cast<std::vector<std::uint8_t>*>(context);
            all.insert(all.end(), bytes, bytes + count);
            return count;
          }};
}

Limits limits_of(const StreamHeader& header) {
  return {header.width, header.height, header.border};
}

template <class Index>
DeviceScan scan(const VoxelBits& bits, const StreamHeader& header, std::uint64_t bytes) {
  DeviceScan result;
  std::vector<std::uint8_t> memory(bytes);
  Encoder encoder;
  meshing::require(encoder.start(header.label(), output_to(result.stream)));
  Extractor<Index> extractor;
  meshing::require(extractor.start(limits_of(header), header.thresholds[0],
                                   {memory.data(), memory.size()}, make_sink(encoder)));
  for (std::uint32_t row = 0; row < bits.rows(); ++row)
    meshing::require(extractor.push_bits(bits.row(row)).status);
  meshing::require(extractor.finish());
  const Statistics statistics = extractor.statistics();
  result.regions = statistics.regions;
  result.fragments = statistics.fragments;
  result.memory_used = extractor.bytes_used();
  return result;
}

}  // namespace

std::uint64_t min_memory(const StreamHeader& header) {
  return Extractor16::minimum_bytes(limits_of(header));
}

DeviceScan scan_regions(const VoxelBits& bits, const StreamHeader& header, std::uint64_t memory) {
  return command::fits_narrow_indices(limits_of(header), memory)
             ? scan<std::uint16_t>(bits, header, memory)
             : scan<std::uint32_t>(bits, header, memory);
}

DeviceScan scan_slices(const VoxelBits& bits, const StreamHeader& header) {
  DeviceScan result;
  const SliceEncoderConfig config{limits_of(header), {header.thresholds[0]}, 0, 1, header.label()};
  std::vector<std::uint8_t> memory(SliceEncoder::minimum_bytes(config));
  SliceEncoder encoder;
  meshing::require(encoder.start(config, {memory.data(), memory.size()}, output_to(result.stream)));
  for (std::uint32_t row = 0; row < bits.rows(); ++row)
    meshing::require(encoder.push_bits(bits.row(row)).status);
  meshing::require(encoder.finish());
  result.memory_used = memory.size();
  return result;
}

}  // namespace discmc::web
