// The four functions that a compiler may call on its own, for programs without a C library. They
// are marked as used, or the optimising linker would drop them.
#include <stddef.h>
#include <stdint.h>

namespace {

// Keeps a loop: otherwise compilers replace the loop of memset by a call of memset.
inline void loop_stays() {
  __asm__ volatile("");
}

}  // namespace

extern "C" {

[[gnu::used]] void* memcpy(void* to, const void* from, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  const uint8_t* f = static_cast<const uint8_t*>(from);
  for (; count > 0; --count, loop_stays()) *t++ = *f++;
  return to;
}

[[gnu::used]] void* memmove(void* to, const void* from, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  const uint8_t* f = static_cast<const uint8_t*>(from);
  if (t < f) return memcpy(to, from, count);
  for (; count > 0; --count, loop_stays()) t[count - 1] = f[count - 1];
  return to;
}

[[gnu::used]] void* memset(void* to, int value, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  for (; count > 0; --count, loop_stays()) *t++ = static_cast<uint8_t>(value);
  return to;
}

[[gnu::used]] int memcmp(const void* left, const void* right, size_t count) {
  const uint8_t* l = static_cast<const uint8_t*>(left);
  const uint8_t* r = static_cast<const uint8_t*>(right);
  for (; count > 0; --count, ++l, ++r)
    if (*l != *r) return *l - *r;
  return 0;
}

}  // extern "C"
