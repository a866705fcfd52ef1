/* The four functions that a compiler may call on its own even when freestanding. */
#include <stddef.h>

void *memcpy(void *to, const void *from, size_t count) {
  char *t = to;
  const char *f = from;
  while (count-- > 0) *t++ = *f++;
  return to;
}

void *memmove(void *to, const void *from, size_t count) {
  char *t = to;
  const char *f = from;
  if (t < f) return memcpy(to, from, count);
  while (count-- > 0) t[count] = f[count];
  return to;
}

void *memset(void *to, int value, size_t count) {
  char *t = to;
  while (count-- > 0) *t++ = (char)value;
  return to;
}

int memcmp(const void *left, const void *right, size_t count) {
  const unsigned char *l = left;
  const unsigned char *r = right;
  for (; count > 0; --count, ++l, ++r)
    if (*l != *r) return *l - *r;
  return 0;
}
