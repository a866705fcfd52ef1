// What the device should have made of the rows: the same extraction, in this process.
#pragma once

#include <cstdint>
#include <discmc/extractor.hpp>
#include <discmc/stream/wire.hpp>
#include <map>
#include <vector>

#include "rows.hpp"

namespace discmc::simulator {

struct ReferenceScan {
  StreamHeader header;
  std::uint64_t memory;  ///< of the device's arena. Units: bytes
  std::map<std::uint32_t, Substitute> skipped;
  std::uint32_t rows;  ///< how many come before the end
  bool is_abandoned;
};

/// The stream of a device that gets these rows. Throws std::invalid_argument when the memory is too
/// small.
std::vector<std::uint8_t> reference_stream(const Rows& rows, const ReferenceScan& scan);

}  // namespace discmc::simulator
