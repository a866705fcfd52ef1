// The user's own data in a stream: a time stamp, a pose, the state of a battery.
#ifndef DISCMC_APPLICATION_RECORD_HPP
#define DISCMC_APPLICATION_RECORD_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// A record goes out at once, in a packet of its own, which takes 22 bytes more than its data, and
/// ends the packet before it early. So tell rarely, and much at once.
struct ApplicationRecord {
  static constexpr size_t max_bytes = 200;
  /// Kinds from here on have a meaning of their own: placement.hpp.
  static constexpr uint8_t first_standard_kind = 240;

  uint8_t kind = 0;    ///< the user's; Limit: below first_standard_kind, which is not checked, as
                       ///< standard records are told in the same way
  uint32_t slice = 0;  ///< where the scan was: as many slices and rows were complete
  uint32_t row = 0;
  const uint8_t* bytes = nullptr;  ///< Owner: whoever tells it; free again when the call returns
  size_t count = 0;                ///< Limit: at most max_bytes
};

}  // namespace discmc

#endif
