// Selects the packets of one scan on a link with several scans.
#ifndef DISCMC_MESH_STREAMS_SCAN_FILTER_HPP
#define DISCMC_MESH_STREAMS_SCAN_FILTER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frames.hpp"

namespace discmc::meshing {

class ScanFilter {
 public:
  explicit ScanFilter(std::uint16_t scan) : scan_(scan) {}
  /// Returns the complete frames of the scan in these bytes, and bytes that are not packets. An
  /// incomplete frame is returned by the call that completes it.
  std::vector<std::uint8_t> select(const std::uint8_t* bytes, std::size_t count);

 private:
  bool is_other_scan(std::vector<std::uint8_t> frame) const;

  std::uint16_t scan_;
  Frames frames_;
};

}  // namespace discmc::meshing

#endif
