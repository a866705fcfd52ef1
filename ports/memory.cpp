// The four functions that a compiler may call on its own, for programs without a C library.
#include <stddef.h>
#include <stdint.h>

extern "C" {

void* memcpy(void* to, const void* from, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  const uint8_t* f = static_cast<const uint8_t*>(from);
  while (count-- > 0) *t++ = *f++;
  return to;
}

void* memmove(void* to, const void* from, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  const uint8_t* f = static_cast<const uint8_t*>(from);
  if (t < f) return memcpy(to, from, count);
  while (count-- > 0) t[count] = f[count];
  return to;
}

void* memset(void* to, int value, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  while (count-- > 0) *t++ = static_cast<uint8_t>(value);
  return to;
}

int memcmp(const void* left, const void* right, size_t count) {
  const uint8_t* l = static_cast<const uint8_t*>(left);
  const uint8_t* r = static_cast<const uint8_t*>(right);
  for (; count > 0; --count, ++l, ++r)
    if (*l != *r) return *l - *r;
  return 0;
}

}  // extern "C"
