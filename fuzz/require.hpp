// How a fuzz target reports a violation.
#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends the program with a message unless the promise holds: that is a finding.
inline void require(bool holds, const char* broken) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", broken);
  std::abort();
}
