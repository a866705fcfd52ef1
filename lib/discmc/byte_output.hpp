// Where an encoder's bytes go.
#ifndef DISCMC_BYTE_OUTPUT_HPP
#define DISCMC_BYTE_OUTPUT_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// Where bytes go: a UART, a ring buffer, a file. Owner: the context belongs to the caller, and
/// must stay until there is another output, or the encoder is used no more.
///
/// write() is called within calls of the encoder or SharedOutput that has it, and of the extractor
/// before that, by the same thread, and at no other time. It may wait. It must not call a function
/// of any of them that does something or saves, nor throw: the library is compiled without
/// exceptions.
struct ByteOutput {
  void* context = nullptr;
  /// Takes up to `count` bytes and returns how many it took, never more; 0 means "not now". On
  /// error, return 0. bytes: valid during the call.
  size_t (*write)(void* context, const uint8_t* bytes, size_t count) = nullptr;
};

}  // namespace discmc

#endif
