// Checks of the caller's memory in a build with an address sanitizer. Other builds check nothing.
//
// A sanitizer does not see an overrun from one part of an arena into the next. So the library
// poisons the slots that are free, and traps if a Limit is broken. Compile the library and every
// file that includes its headers with the same sanitizers. The memory is accessible to the caller
// again after finish(), after bytes_used() or save(), and when another object starts with it.
// ASAN_OPTIONS=allow_user_poisoning=0 turns the poison off.
//
// DISCMC_CHECKED adds red zones between the arrays of an arena, for tests of the library. Arenas
// need more memory then; sizes.h does not count it.
#ifndef DISCMC_BASE_CHECKS_HPP
#define DISCMC_BASE_CHECKS_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>

#if defined(__SANITIZE_ADDRESS__)
#define DISCMC_HAS_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define DISCMC_HAS_ADDRESS_SANITIZER
#endif
#endif

#if defined(DISCMC_HAS_ADDRESS_SANITIZER)
// As <sanitizer/asan_interface.h> declares them: the library includes no header of a compiler.
extern "C" {
void __asan_poison_memory_region(void const volatile* bytes, size_t count);
void __asan_unpoison_memory_region(void const volatile* bytes, size_t count);
void __sanitizer_print_stack_trace();
}
#elif defined(DISCMC_CHECKED)
#error "DISCMC_CHECKED needs an address sanitizer: -fsanitize=address"
#endif

/// DISCMC_LIMIT() traps if a Limit is broken. Other builds do not even read its operands, so their
/// object code is the same without it. DISCMC_NO_ADDRESS_CHECK precedes a function that may
/// read what is poisoned.
#if defined(DISCMC_HAS_ADDRESS_SANITIZER)
#define DISCMC_LIMIT(is_kept) ((is_kept) ? static_cast<void>(0) : ::discmc::trap())
#define DISCMC_NO_ADDRESS_CHECK [[gnu::no_sanitize_address]]
#else
#define DISCMC_LIMIT(is_kept) static_cast<void>(sizeof(is_kept))
#define DISCMC_NO_ADDRESS_CHECK
#endif

namespace discmc {

/// The poisoned bytes behind each array of an arena.
#if defined(DISCMC_CHECKED)
constexpr size_t red_zone_bytes = 64;
#else
constexpr size_t red_zone_bytes = 0;
#endif

#if defined(DISCMC_HAS_ADDRESS_SANITIZER)

/// Forbids access to bytes until unpoison(). Bytes that may be on the stack stay accessible: the
/// next function with the same frame would find them poisoned. If eight aligned bytes end with
/// accessible ones, all eight stay accessible.
DISCMC_NOINLINE inline void poison(const void* bytes, size_t count) {
  constexpr uintptr_t stack_bytes = uintptr_t{8} << 20;
  const auto frame = reinterpret_cast<uintptr_t>(__builtin_frame_address(0));
  if (reinterpret_cast<uintptr_t>(bytes) - frame > stack_bytes)
    __asan_poison_memory_region(bytes, count);
}
inline void unpoison(const void* bytes, size_t count) {
  __asan_unpoison_memory_region(bytes, count);
}

/// Ends the program, and prints the stack.
[[noreturn]] DISCMC_NOINLINE inline void trap() {
  __sanitizer_print_stack_trace();
  __builtin_trap();
}

#else

DISCMC_ALWAYS_INLINE void poison(const void*, size_t) {}
DISCMC_ALWAYS_INLINE void unpoison(const void*, size_t) {}

#endif

}  // namespace discmc

#endif
