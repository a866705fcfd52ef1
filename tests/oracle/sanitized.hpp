// Whether an address sanitizer watches, or the library is one of mutants: the tests that try
// everything then try a part of it, as each scan takes some twenty times as long, or they are run
// some thousand times.
#ifndef DISCMC_TESTS_ORACLE_SANITIZED_HPP
#define DISCMC_TESTS_ORACLE_SANITIZED_HPP

#include <cstdint>

namespace discmc::reference {

#if defined(__SANITIZE_ADDRESS__) || defined(MUTANTS_HPP)
constexpr bool is_sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif
#else
constexpr bool is_sanitized = false;
#endif

/// The step through a list of cases: all of them, or one in `thinned` of them.
constexpr uint32_t step(uint32_t thinned) {
  return is_sanitized ? thinned : 1;
}

}  // namespace discmc::reference

#endif
