// How many cases the tests try that would try everything: a part of them, or all where the
// environment has DISCMC_ALL, as under `scripts/test --all`.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace discmc::reference {

// Always a part with an address sanitizer, where each scan takes some twenty times as long.
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

/// The step through a list of cases: all of them, or one in `thinned` of them.
inline uint32_t step(uint32_t thinned) {
  static const bool takes_all = !is_slow && std::getenv("DISCMC_ALL") != nullptr;
  return takes_all ? 1 : thinned;
}

}  // namespace discmc::reference
