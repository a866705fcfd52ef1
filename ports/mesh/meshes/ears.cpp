#include "ears.hpp"

#include <algorithm>

namespace discmc::meshing {
namespace {

// Whether two sides have a point in common. Limit: the boxes around them have one.
bool meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const auto on_both_sides = [](std::int64_t one, std::int64_t other) {
    return ((one ^ other) < 0) | (one == 0) | (other == 0);
  };
  return on_both_sides(doubled_area(a, b, c), doubled_area(a, b, d)) &&
         on_both_sides(doubled_area(c, d, a), doubled_area(c, d, b));
}

// Whether a ring that never turns to the right winds once: then it turns upwards once.
bool winds_once(const std::vector<PlanePoint>& points) {
  const auto rise_to = [&points](std::size_t i) {
    return points[i].v - points[i > 0 ? i - 1 : points.size() - 1].v;
  };
  bool goes_down = false;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (rise_to(i) != 0) goes_down = rise_to(i) < 0;
  int turns = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (rise_to(i) == 0) continue;
    if (goes_down && rise_to(i) > 0) ++turns;
    goes_down = rise_to(i) < 0;
  }
  return turns == 1;
}

}  // namespace

bool Ears::cut(const std::vector<PlanePoint>& points, std::vector<Triangle>& triangles,
               std::vector<std::uint32_t>& pairs) {
  if (points.size() < 3 || points.size() > max_points) return false;
  link_all(points);
  if (blocker_count_ == 0 ? !winds_once(points) : !is_simple(points)) return false;
  triangles.resize(points.size() - 2);
  pairs.resize(3 * triangles.size());
  cut_count_ = 0;
  std::uint32_t at = 0;
  for (std::uint32_t tries = 0; left_ > 3;) {
    if (blocks_[at] || !is_ear(points, at)) {
      if (++tries > left_) return false;
      at = next_[at];
      continue;
    }
    tries = 0;
    const std::uint32_t before = previous_[at], after = next_[at];
    cut_off(at, triangles, pairs);
    update(points, before);
    update(points, after);
    at = next_[after];  // ears beside each other make slivers
  }
  if (is_flat_or_reflex(points, at)) return false;
  cut_off(at, triangles, pairs);
  return true;
}

void Ears::link_all(const std::vector<PlanePoint>& points) {
  left_ = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < left_; ++i) {
    next_[i] = i + 1 < left_ ? i + 1 : 0;
    previous_[i] = i > 0 ? i - 1 : left_ - 1;
    inner_[i] = DelaunayFlips::no_side;
  }
  blocker_count_ = 0;
  for (std::uint32_t i = 0; i < left_; ++i) {
    blocks_[i] = is_flat_or_reflex(points, i);
    blocker_[blocker_count_] = i;
    blocker_count_ += blocks_[i] ? 1 : 0;
  }
}

// Whether sides meet neighbours only. Limit: those do so in one point.
bool Ears::is_simple(const std::vector<PlanePoint>& points) {
  const std::size_t count = points.size();
  const auto point = [&points, count](std::size_t i) -> const PlanePoint& {
    return points[i < count ? i : i - count];
  };
  const auto meet_at = [&](std::size_t i, std::size_t j) {
    return meet(point(i), point(i + 1), point(j), point(j + 1));
  };
  if (count == 3) return true;
  set_boxes(points);
  // About half of these pairs are near each other, so a branch would often be mispredicted.
  bool is_crossed = false;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_near = are_near(i, i + 2), meets = meet_at(i, i + 2);
    is_crossed |= is_near & meets;
  }
  if (is_crossed) return false;
  for (std::size_t apart = 3; 2 * apart <= count; ++apart)
    for (std::size_t i = 0; i < count; ++i)
      if (are_near(i, i + apart) && meet_at(i, i + apart)) return false;
  return true;
}

void Ears::set_boxes(const std::vector<PlanePoint>& points) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const PlanePoint &from = points[i], &to = points[i + 1 < count ? i + 1 : 0];
    low_u_[i] = low_u_[i + count] = static_cast<std::int32_t>(std::min(from.u, to.u));
    high_u_[i] = high_u_[i + count] = static_cast<std::int32_t>(std::max(from.u, to.u));
    low_v_[i] = low_v_[i + count] = static_cast<std::int32_t>(std::min(from.v, to.v));
    high_v_[i] = high_v_[i + count] = static_cast<std::int32_t>(std::max(from.v, to.v));
  }
}

bool Ears::is_flat_or_reflex(const std::vector<PlanePoint>& points, std::uint32_t at) const {
  return doubled_area(points[previous_[at]], points[at], points[next_[at]]) <= 0;
}

bool Ears::is_ear(const std::vector<PlanePoint>& points, std::uint32_t at) const {
  const std::uint32_t before = previous_[at], after = next_[at];
  const PlanePoint &a = points[before], &b = points[at], &c = points[after];
  for (std::uint32_t i = 0; i < blocker_count_; ++i) {
    const PlanePoint& point = points[blocker_[i]];
    // Not negative if no area is: the point is inside. At a and c two areas are zero.
    const std::int64_t areas =
        doubled_area(a, b, point) | doubled_area(b, c, point) | doubled_area(c, a, point);
    if (areas >= 0 && blocker_[i] != before && blocker_[i] != after) return false;
  }
  return true;
}

// The triangle's third side becomes the one from the point before to the point after.
void Ears::cut_off(std::uint32_t at, std::vector<Triangle>& triangles,
                   std::vector<std::uint32_t>& pairs) {
  const std::uint32_t before = previous_[at], after = next_[at];
  std::uint32_t side = 3 * cut_count_;
  triangles[cut_count_++] = {before, at, after};
  const std::uint32_t last = left_ == 3 ? inner_[after] : DelaunayFlips::no_side;
  for (const std::uint32_t pair : {inner_[before], inner_[at], last}) {
    if (pair != DelaunayFlips::no_side) pairs[pair] = side;
    pairs[side++] = pair;
  }
  inner_[before] = side - 1;
  next_[before] = after;
  previous_[after] = before;
  --left_;
}

// A point that blocks ears may cease to when a neighbour is cut off; no other point begins to.
void Ears::update(const std::vector<PlanePoint>& points, std::uint32_t at) {
  if (!blocks_[at] || is_flat_or_reflex(points, at)) return;
  blocks_[at] = false;
  *std::find(blocker_, blocker_ + blocker_count_, at) = blocker_[blocker_count_ - 1];
  --blocker_count_;
}

}  // namespace discmc::meshing
