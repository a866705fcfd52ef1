// Reports violations of promises by a fuzz target.
#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends the program with a message unless the promise holds.
inline void require(bool holds, const char* broken) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", broken);
  std::abort();
}
