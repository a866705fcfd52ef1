// The share of cases that an exhaustive test tries: a part, or all if DISCMC_ALL is in the
// environment, as under `scripts/test --all`.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace discmc::reference {

// An address sanitizer always gets a part, because each scan takes about twenty times as long.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool is_slow = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool is_slow = true;
#else
constexpr bool is_slow = false;
#endif
#else
constexpr bool is_slow = false;
#endif

/// Returns the step through a list of cases: 1, or `thinned` to try one in that many.
inline uint32_t step(uint32_t thinned) {
  static const bool takes_all = !is_slow && std::getenv("DISCMC_ALL") != nullptr;
  return takes_all ? 1 : thinned;
}

}  // namespace discmc::reference
