// Freeman chains: runs of equal links, and their integer properties.
//
// A chain is a starting vertex and a list of runs. A side longer than the length field of a run
// continues in a second run of the same direction. So a corner is a change of direction, not a
// change of run.
#ifndef DISCMC_CHAIN_HPP
#define DISCMC_CHAIN_HPP

#include <discmc/lattice.hpp>

namespace discmc {

/// Equal links in sequence, in 32 bits: a straight part of a chain. A default Run is empty.
class Run {
 public:
  static constexpr uint32_t max_length = (uint32_t{1} << 28) - 1;

  constexpr Run() = default;

  /// Limit: length 1 to max_length. Units: links.
  static constexpr Run straight(Direction direction, uint32_t length) {
    return Run(length << 3 | direction);
  }
  /// A run from its code(), as in discmc_event. Check a code of unknown origin with is_run_of().
  static constexpr Run from_code(uint32_t code) { return Run(code); }

  constexpr uint32_t code() const { return code_; }
  constexpr bool is_empty() const { return code_ == 0; }
  constexpr Direction direction() const { return code_ & 7; }
  constexpr uint32_t length() const { return code_ >> 3; }

  /// Appends the other run, and returns true, if both have the same direction and the sum of the
  /// lengths is at most max_length.
  constexpr bool absorb(Run other) {
    if (direction() != other.direction()) return false;
    if (length() + other.length() > max_length) return false;
    code_ += other.length() << 3;
    return true;
  }

 private:
  explicit constexpr Run(uint32_t code) : code_(code) {}
  uint32_t code_ = 0;
};

constexpr bool operator==(Run a, Run b) {
  return a.code() == b.code();
}
constexpr bool operator!=(Run a, Run b) {
  return a.code() != b.code();
}

/// The vector from the start of the chain to its end. Units: half-steps. Limit: no coordinate
/// overflows.
constexpr Vertex displacement(Incidence incidence, const Run* runs, uint32_t count) {
  Vertex sum{0, 0, 0};
  for (uint32_t i = 0; i < count; ++i) {
    const Vertex step = direction_vector(incidence, runs[i].direction());
    const int32_t length = static_cast<int32_t>(runs[i].length());
    sum = sum + Vertex{step.x * length, step.y * length, step.z * length};
  }
  return sum;
}

/// Whether the chain ends where it starts. Limit: as displacement().
constexpr bool is_closed(Incidence incidence, const Run* runs, uint32_t count) {
  return displacement(incidence, runs, count) == Vertex{0, 0, 0};
}

/// Reverses the chain in place: the same vertices from the end to the start. The new start is the
/// old end. Cost: one pass.
constexpr void reverse(Incidence incidence, Run* runs, uint32_t count) {
  for (uint32_t i = 0; i < (count + 1) / 2; ++i) {
    const Run first = runs[i];
    const Run last = runs[count - 1 - i];
    const auto turned = [incidence](Run run) {
      return Run::straight(opposite_direction(incidence, run.direction()), run.length());
    };
    runs[i] = turned(last);
    runs[count - 1 - i] = turned(first);
  }
}

/// Twice the area of a closed chain, times the length of the incidence's normal (1, the square root
/// of 2 or 3): an exact integer. Positive for an outer ring, negative for a hole. Units: square
/// half-steps. Limit: a ring of a scan; others may overflow.
constexpr int64_t twice_area(Incidence incidence, const Run* runs, uint32_t count) {
  const Vertex n = incidence_normal(incidence);
  int64_t sum = 0;
  int64_t x = 0, y = 0, z = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const Vertex step = direction_vector(incidence, runs[i].direction());
    const int64_t length = runs[i].length();
    const int64_t dx = step.x * length, dy = step.y * length, dz = step.z * length;
    sum += n.x * (y * dz - z * dy) + n.y * (z * dx - x * dz) + n.z * (x * dy - y * dx);
    x += dx;
    y += dy;
    z += dz;
  }
  return sum;
}

// ---- Chains in their plane.
//
// Coordinates wrap: any start and any runs of the incidence are safe, and those of a scan give
// exact results.

/// Whether the number is an incidence.
constexpr bool is_incidence(Incidence incidence) {
  return incidence < incidence_codes && incidence != no_incidence;
}
/// Whether the direction exists in the planes of the incidence.
constexpr bool is_direction_of(Incidence incidence, Direction direction) {
  return direction < direction_count(incidence);
}
/// Whether the run has such a direction and a valid length.
constexpr bool is_run_of(Incidence incidence, Run run) {
  return is_direction_of(incidence, run.direction()) && run.length() >= 1 &&
         run.length() <= Run::max_length;
}

/// The end of a run that starts at `from`. Limit: is_run_of(incidence, run).
constexpr Vertex after_run(Incidence incidence, const Vertex& from, Run run) {
  Vertex to = from;
  translate(to, incidence, run.direction(), run.length());
  return to;
}

/// The dot product of the incidence's normal and a vertex: one number for all vertices of a plane.
constexpr int32_t plane_offset(Incidence incidence, const Vertex& p) {
  const Vertex n = incidence_normal(incidence);
  const auto term = [](int32_t factor, int32_t coordinate) {
    return static_cast<uint32_t>(factor) * static_cast<uint32_t>(coordinate);
  };
  return static_cast<int32_t>(term(n.x, p.x) + term(n.y, p.y) + term(n.z, p.z));
}

}  // namespace discmc

#endif
