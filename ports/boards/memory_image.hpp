// The memory of a program without an operating system: static variables and the stack.
#pragma once

#include <stddef.h>
#include <stdint.h>

extern "C" {
// From sections.ld.
extern uintptr_t stack_begin[], stack_end[];
extern uintptr_t data_begin[], data_end[];
extern const uintptr_t data_load[];
extern uintptr_t bss_begin[], bss_end[];
}

namespace memory_image {

constexpr uintptr_t paint = 0xA5C3A5C3;

/// Paints the stack below the stack pointer. Words that are still painted at the end were never
/// used. Inlined, because a frame of its own would be painted.
[[gnu::always_inline]] inline void paint_stack(const uintptr_t* stack_pointer) {
  for (uintptr_t* word = stack_begin; word < stack_pointer; ++word) *word = paint;
}

/// Initialises static variables.
[[gnu::always_inline]] inline void initialise() {
  const uintptr_t* from = data_load;
  for (uintptr_t* to = data_begin; to < data_end;) *to++ = *from++;
  for (uintptr_t* to = bss_begin; to < bss_end;) *to++ = 0;
}

/// The greatest depth of the stack so far. Units: bytes.
inline size_t stack_used() {
  const uintptr_t* word = stack_begin;
  while (word < stack_end && *word == paint) ++word;
  return static_cast<size_t>(stack_end - word) * sizeof *word;
}

/// The size of the stack. Units: bytes.
inline size_t stack_bytes() {
  return static_cast<size_t>(stack_end - stack_begin) * sizeof *stack_begin;
}

}  // namespace memory_image
