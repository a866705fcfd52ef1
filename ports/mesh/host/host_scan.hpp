// A HostExtractor with memory of its own.
#ifndef DISCMC_MESH_HOST_HOST_SCAN_HPP
#define DISCMC_MESH_HOST_HOST_SCAN_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "host_extractor.hpp"
#include "require.hpp"

namespace discmc::meshing {

/// Returns the memory of a scan on a PC, enough for slices of any kind. Unused pages cost nothing.
/// Units: bytes.
template <class Normals = BitIntake>
std::uint64_t generous_bytes_for(const Limits& limits) {
  constexpr std::uint64_t generous_bytes = std::uint64_t{64} << 20;
  return std::max(generous_bytes,
                  2 * detail::sizing::minimum_bytes<std::uint32_t, Normals>(limits));
}

/// Extracts rows of bits; further scans use the same memory.
class HostScan {
 public:
  /// sink: accepts every event at once. regions: receives regions of one ring before the sink.
  /// Owner: the caller.
  void start(const Limits& limits, const Sink& sink, const RegionReceiver& regions = {}) {
    const std::size_t bytes = generous_bytes_for(limits);
    if (bytes_ < bytes) memory_.reset(new std::uint8_t[bytes]);
    bytes_ = std::max(bytes_, bytes);
    constexpr std::int32_t threshold = 1;  // of bits
    require(extractor_.start(limits, threshold, {memory_.get(), bytes_}, sink));
    extractor_.set_region_receiver(regions);
  }
  /// bits: as Extractor::push_bits().
  void push(const std::uint8_t* bits) { require(extractor_.push_bits(bits).status); }
  void finish() { require(extractor_.finish()); }

  const Statistics& statistics() const { return extractor_.statistics(); }

 private:
  HostExtractor extractor_;
  std::unique_ptr<std::uint8_t[]> memory_;
  std::size_t bytes_ = 0;
};

}  // namespace discmc::meshing

#endif
