// The configuration of a slice encoder whose stream begins with a given header.
#pragma once

#include <algorithm>
#include <discmc/slice_encoder.hpp>

namespace discmc::test {

inline SliceEncoderConfig slice_config(const StreamHeader& header,
                                       uint32_t key_slice_interval = 0) {
  SliceEncoderConfig config{{header.width, header.height, header.border},
                            {},
                            key_slice_interval,
                            header.surface_count,
                            header.label()};
  std::copy_n(header.thresholds, StreamHeader::max_surfaces, config.thresholds);
  return config;
}

}  // namespace discmc::test
