// Scans whose instructions are counted, and their samples.
#pragma once

#include <discmc/extractor.hpp>

#include "marks.hpp"

namespace discmc::test {

inline size_t discard_bytes(void*, const uint8_t*, size_t count) {
  return count;
}

// ---- volumes with a sample for each x, y and z ----

constexpr int32_t threshold = 192;

inline uint8_t outside(int32_t, int32_t, int32_t) {
  return 0;
}

constexpr Limits ball{48, 48};
inline uint8_t inside_ball(int32_t x, int32_t y, int32_t z) {
  constexpr int32_t size = ball.width;
  const Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
  return static_cast<uint8_t>(255 - dot_product(v, v) / 26);
}

/// Returns the rows of such a volume one after the other.
struct RowsOf {
  uint8_t (*sample)(int32_t x, int32_t y, int32_t z);
  Limits limits;
  int32_t next = 0;

  template <class Sample>
  void read(Sample* row) {
    const auto width = static_cast<int32_t>(limits.width);
    const auto height = static_cast<int32_t>(limits.height);
    for (int32_t x = 0; x < width; ++x) row[x] = sample(x, next % height, next / height);
    ++next;
  }
};

/// Counts the instructions of all calls of push(), one row per call.
template <class Sample, class Scanner, class Rows>
bool push_rows(Scanner& scanner, const Limits& limits, uint32_t slices, Rows rows) {
  constexpr uint32_t widest = 256;
  alignas(4) static Sample row[widest];
  for (uint32_t i = 0; i < limits.height * slices; ++i) {
    rows.read(row);
    count_on();
    const Status status = scanner.push(row, limits.width).status;
    count_off();
    if (status != Status::ok) return false;
  }
  return true;
}

/// Also counts finish(), then prints the sum.
template <class Sample, class Scanner, class Rows>
bool push_and_finish(Scanner& scanner, const Limits& limits, uint32_t slices, Rows rows) {
  if (!push_rows<Sample>(scanner, limits, slices, rows)) return false;
  count_on();
  const Status status = scanner.finish();
  count_off();
  count_report();
  return status == Status::ok;
}

}  // namespace discmc::test
