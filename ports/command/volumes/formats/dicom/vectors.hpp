// Vectors in the space of the patient. Units: millimetres.
#pragma once

#include <cmath>
#include <cstddef>

#include "meshing.hpp"
#include "surface/point.hpp"

namespace discmc::command {

using Vector = Point;

/// a + factor * b.
inline Vector sum(const Vector& a, double factor, const Vector& b) {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] + factor * b[i];
  return result;
}

inline double length(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}

}  // namespace discmc::command
