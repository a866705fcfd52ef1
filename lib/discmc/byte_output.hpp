// Where an encoder's bytes go.
#ifndef DISCMC_BYTE_OUTPUT_HPP
#define DISCMC_BYTE_OUTPUT_HPP

#include <stddef.h>
#include <stdint.h>

namespace discmc {

/// Where bytes go: a UART, a ring buffer, a file. Owner: the context belongs to the caller.
struct ByteOutput {
  void* context = nullptr;
  /// Takes up to `count` bytes and returns how many it took; 0 means "not now". On error, return 0.
  size_t (*write)(void* context, const uint8_t* bytes, size_t count) = nullptr;
};

}  // namespace discmc

#endif
