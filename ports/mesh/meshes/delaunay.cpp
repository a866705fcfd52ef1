#include "delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace discmc::meshing {
namespace {

// Average number per triangle, which limits the time for hostile input.
constexpr std::size_t max_flips = 32;

std::uint32_t next(std::uint32_t side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}
std::uint32_t previous(std::uint32_t side) {
  return side % 3 == 0 ? side + 2 : side - 1;
}

std::uint32_t& start_of(std::vector<Triangle>& triangles, std::uint32_t side) {
  return triangles[side / 3][side % 3];
}

}  // namespace

// Whether the angles at c and d, opposite to the edge a b, exceed half a turn together. Exact for
// distances up to 2^12.
bool is_in_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c,
                  const PlanePoint& d) {
  constexpr double max_rounding = 1e-15;  // exceeds the rounding error
  const auto cosine = [&](const PlanePoint& apex) {
    return static_cast<double>((a.u - apex.u) * (b.u - apex.u) + (a.v - apex.v) * (b.v - apex.v));
  };
  const double cosine_c = cosine(c), cosine_d = cosine(d);
  if (cosine_c >= 0 && cosine_d >= 0) return false;
  const double one = static_cast<double>(doubled_area(c, a, b)) * cosine_d;
  const double other = static_cast<double>(doubled_area(d, b, a)) * cosine_c;
  return one + other < -max_rounding * (std::abs(one) + std::abs(other));
}

void DelaunayFlips::improve(const std::vector<PlanePoint>& points,
                            std::vector<Triangle>& triangles) {
  pair_sides(triangles);
  flip_all(points, triangles);
}

void DelaunayFlips::improve(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
                            std::vector<Side>& pairs) {
  twins_.swap(pairs);
  flip_all(points, triangles);
}

void DelaunayFlips::flip_all(const std::vector<PlanePoint>& points,
                             std::vector<Triangle>& triangles) {
  changed_.clear();
  waiting_.resize(twins_.size());
  Side* end = waiting_.begin();
  for (Side side = 0; side < twins_.size(); ++side) {
    *end = side;
    end += side < twins_[side] && twins_[side] != no_side ? 1 : 0;
  }
  waiting_.resize(static_cast<std::size_t>(end - waiting_.begin()));
  flip_waiting(points, triangles);
}

// Cuts a triangle in three at the point. If the point lies on an edge, one of the three has no area
// until that edge is flipped.
void DelaunayFlips::insert(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
                           std::uint32_t triangle) {
  const auto point = static_cast<std::uint32_t>(points.size() - 1);
  const auto is_on = [&](Side side) {
    return doubled_area(points[start_of(triangles, side)], points[start_of(triangles, next(side))],
                        points[point]) == 0;
  };
  Side side = 3 * triangle;
  while (side < 3 * triangle + 2 && !is_on(side)) ++side;
  const bool is_on_edge = is_on(side);
  const std::uint32_t a = start_of(triangles, side), b = start_of(triangles, next(side)),
                      c = start_of(triangles, previous(side));
  const Side outer[] = {twins_[side], twins_[next(side)], twins_[previous(side)]};
  const auto second = static_cast<std::uint32_t>(triangles.size()), third = second + 1;
  triangles[triangle] = {a, b, point};
  triangles.push_back({b, c, point});
  triangles.push_back({c, a, point});
  twins_.resize(3 * triangles.size(), no_side);
  link(3 * triangle, outer[0]);
  link(3 * second, outer[1]);
  link(3 * third, outer[2]);
  link(3 * triangle + 1, 3 * second + 2);
  link(3 * second + 1, 3 * third + 2);
  link(3 * third + 1, 3 * triangle + 2);
  changed_ = {triangle, second, third};
  waiting_.resize(0);
  for (const Side outside : {3 * third, 3 * second}) waiting_.push_back(outside);
  if (is_on_edge)
    flip(triangles, 3 * triangle);
  else
    waiting_.push_back(3 * triangle);
  flip_waiting(points, triangles);
}

void DelaunayFlips::flip_waiting(const std::vector<PlanePoint>& points,
                                 std::vector<Triangle>& triangles) {
  // Nearly Delaunay triangles need few flips; hostile ones need a limit.
  for (std::size_t flips = max_flips * triangles.size(); flips > 0 && !waiting_.empty();) {
    const Side side = waiting_.back();
    waiting_.resize(waiting_.size() - 1);
    const Side twin = twins_[side];
    if (twin == no_side) continue;
    const auto start = [&](Side from) -> const PlanePoint& {
      return points[start_of(triangles, from)];
    };
    if (is_in_circle(start(side), start(twin), start(previous(side)), start(previous(twin)))) {
      flip(triangles, side);
      --flips;
    }
  }
}

void DelaunayFlips::pair_sides(const std::vector<Triangle>& triangles) {
  ends_.clear();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      ends_.push_back({low, high, static_cast<Side>(3 * t + i)});
    }
  std::sort(ends_.begin(), ends_.end(), [](const Ends& a, const Ends& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  twins_.assign(ends_.size(), no_side);
  for (std::size_t i = 1; i < ends_.size(); ++i)
    if (ends_[i].low == ends_[i - 1].low && ends_[i].high == ends_[i - 1].high)
      link(ends_[i].side, ends_[i - 1].side);
}

void DelaunayFlips::link(Side a, Side b) {
  twins_[a] = b;
  if (b != no_side) twins_[b] = a;
}

// Replaces the diagonal of the four points. The triangles a b c and b a d share the side a b; they
// become a d c and d b c.
void DelaunayFlips::flip(std::vector<Triangle>& triangles, Side side) {
  const Side twin = twins_[side];
  const Side outer[] = {twins_[next(twin)], twins_[previous(twin)], twins_[next(side)],
                        twins_[previous(side)]};  // of sides a d, d b, b c and c a
  const std::uint32_t a = start_of(triangles, side), b = start_of(triangles, twin),
                      c = start_of(triangles, previous(side)),
                      d = start_of(triangles, previous(twin));
  const Side first = side - side % 3, second = twin - twin % 3;
  triangles[first / 3] = {a, d, c};
  triangles[second / 3] = {d, b, c};
  link(first, outer[0]);
  link(second, outer[1]);
  link(second + 1, outer[2]);
  link(first + 2, outer[3]);
  link(first + 1, second + 2);
  for (const Side changed : {first, second, second + 1, first + 2}) waiting_.push_back(changed);
  changed_.insert(changed_.end(), {first / 3, second / 3});
}

}  // namespace discmc::meshing
