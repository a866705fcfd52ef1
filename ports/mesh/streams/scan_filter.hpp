// The packets of one scan, of a link that carries several.
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
  /// The frames of the scan among these bytes, whole, and what is no packet. A frame that they end
  /// within comes with the bytes that end it.
  std::vector<std::uint8_t> take(const std::uint8_t* bytes, std::size_t count);

 private:
  bool is_other_scan(std::vector<std::uint8_t> frame) const;

  std::uint16_t scan_;
  Frames frames_;
};

}  // namespace discmc::meshing

#endif
