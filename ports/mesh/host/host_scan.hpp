// A scan on a PC, with its memory.
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

/// Returns an arena that suffices for most volumes. Unused pages cost nothing. Units: bytes.
template <class Normals = detail::trace::BitIntake>
std::uint64_t generous_bytes_for(const Limits& limits) {
  constexpr std::uint64_t generous_bytes = std::uint64_t{64} << 20;
  return std::max(generous_bytes,
                  2 * detail::sizing::minimum_bytes<std::uint32_t, Normals>(limits));
}

/// Extracts rows of bits; further scans use the same memory.
class HostScan {
 public:
  /// sink: accepts every event at once. regions: receives regions of one ring before the sink.
  /// slices: of the scan, if known; only then it may have more than host::CornerCode::max_slices.
  /// Owner: the caller.
  void start(const Limits& limits, const Sink& sink, const RegionReceiver& regions = {},
             std::uint32_t slices = 0) {
    is_deep_ = slices > host::CornerCode::max_slices;
    const std::size_t bytes = is_deep_ ? generous_bytes_for(limits)
                                       : detail::sizing::minimum_bytes<std::uint32_t>(limits);
    if (bytes_ < bytes) memory_.reset(new std::uint8_t[bytes]);
    bytes_ = std::max(bytes_, bytes);
    constexpr std::int32_t threshold = 1;  // of bits
    const Memory memory{memory_.get(), bytes_};
    require(is_deep_ ? deep_extractor_.start(limits, threshold, memory, sink)
                     : extractor_.start(limits, threshold, memory, sink));
    if (!is_deep_) extractor_.set_region_receiver(regions);
  }
  /// bits: as Extractor::push_bits(). Throws std::length_error if there are too many slices.
  void push(const std::uint8_t* bits) {
    const Status status =
        (is_deep_ ? deep_extractor_.push_bits(bits) : extractor_.push_bits(bits)).status;
    if (status == Status::too_many_slices)
      throw std::length_error("too many slices: a scan slice by slice has at most " +
                              std::to_string(host::CornerCode::max_slices) +
                              "; finish it, or give the whole array");
    require(status);
  }
  void finish() { require(is_deep_ ? deep_extractor_.finish() : extractor_.finish()); }

  const Statistics& statistics() const {
    return is_deep_ ? deep_extractor_.statistics() : extractor_.statistics();
  }

 private:
  HostExtractor extractor_;
  Extractor32 deep_extractor_;
  bool is_deep_ = false;
  std::unique_ptr<std::uint8_t[]> memory_;
  std::size_t bytes_ = 0;
};

}  // namespace discmc::meshing

#endif
