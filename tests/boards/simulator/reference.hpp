// The expected stream: extracts the same rows in this process.
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
  std::uint32_t rows;  ///< number of rows before the end
  bool is_abandoned;
};

/// Returns the stream of a device that receives these rows. Throws std::invalid_argument if the
/// memory is too little.
std::vector<std::uint8_t> reference_stream(const Rows& rows, const ReferenceScan& scan);

}  // namespace discmc::simulator
