// A HostExtractor with the memory of its rows.
#ifndef DISCMC_MESH_HOST_HOST_SCAN_HPP
#define DISCMC_MESH_HOST_HOST_SCAN_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "host_extractor.hpp"
#include "require.hpp"

namespace discmc::meshing {

/// Extracts rows of bits; further scans use the same memory.
class HostScan {
 public:
  /// sink: accepts every event at once. regions: receives regions of one ring before the sink.
  /// Owner: the caller.
  void start(const Limits& limits, const Sink& sink, const RegionReceiver& regions = {}) {
    const std::size_t bytes = detail::sizing::minimum_bytes<std::uint32_t>(limits);
    if (bytes_ < bytes) memory_.reset(new std::uint8_t[bytes]);
    bytes_ = std::max(bytes_, bytes);
    constexpr std::int32_t threshold = 1;  // of bits
    require(extractor_.start(limits, threshold, {memory_.get(), bytes_}, sink));
    extractor_.set_region_receiver(regions);
  }
  /// bits: as Extractor::push_bits(). Throws std::length_error if there are too many slices.
  void push(const std::uint8_t* bits) {
    const Status status = extractor_.push_bits(bits).status;
    if (status == Status::too_many_slices)
      throw std::length_error("a scan has at most " + std::to_string(host::CornerCode::max_slices) +
                              " slices; give the volume in parts");
    require(status);
  }
  void finish() { require(extractor_.finish()); }

  const Statistics& statistics() const { return extractor_.statistics(); }

 private:
  HostExtractor extractor_;
  std::unique_ptr<std::uint8_t[]> memory_;
  std::size_t bytes_ = 0;
};

}  // namespace discmc::meshing

#endif
