#include "box_tree.hpp"

#include <cmath>

#include "point_distance.hpp"

namespace discmc::host {
namespace {

constexpr std::size_t most_waiting = 128;  // the tree has at most 64 levels

// The place of a triangle on a curve through space on which neighbours are mostly near: the bits of
// its three coordinates in turn (G. M. Morton, 1966).
std::uint64_t place_on_curve(const Corners& triangle, const Box& all) {
  constexpr unsigned bits = 20;
  std::array<std::uint64_t, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = all.high[axis] - all.low[axis];
    const double middle = (triangle[0][axis] + triangle[1][axis] + triangle[2][axis]) / 3;
    const double part = size > 0 ? (middle - all.low[axis]) / size : 0;
    cell[axis] = static_cast<std::uint64_t>(part * ((1U << bits) - 1));
  }
  std::uint64_t place = 0;
  for (unsigned bit = 0; bit < bits; ++bit)
    for (std::size_t axis = 0; axis < 3; ++axis)
      place |= (cell[axis] >> bit & 1) << (std::size_t{3} * bit + axis);
  return place;
}

}  // namespace

double Box::squared_distance(const Point& point) const {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double away = std::max({low[axis] - point[axis], point[axis] - high[axis], 0.0});
    sum += away * away;
  }
  return sum;
}

BoxTree::BoxTree(const std::vector<Corners>& triangles) : triangles_(triangles) {
  Box all;
  for (const Corners& triangle : triangles) all.include(Box(triangle));
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (const Corners& triangle : triangles)
    order.emplace_back(place_on_curve(triangle, all), static_cast<std::uint32_t>(order.size()));
  std::sort(order.begin(), order.end());
  places_.reserve(triangles.size());
  for (const auto& [curve, place] : order) places_.push_back(place);

  while (leaves_ * leaf_size < places_.size()) leaves_ *= 2;
  boxes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < places_.size(); ++i)
    boxes_[leaves_ + i / leaf_size].include(Box(triangle(i)));
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    boxes_[node] = boxes_[2 * node];
    boxes_[node].include(boxes_[2 * node + 1]);
  }
}

double BoxTree::distance(const Point& point, double enough) {
  struct Waiting {
    std::size_t node;
    double squared_distance;
  };
  const double squared_enough = enough * enough;
  Nearest nearest{squared_distance(point, triangle(last_)), last_};
  std::array<Waiting, most_waiting> waiting;
  std::size_t count = 0;
  waiting[count++] = {1, boxes_[1].squared_distance(point)};
  while (count > 0 && nearest.squared_distance > squared_enough) {
    const Waiting next = waiting[--count];
    if (next.squared_distance >= nearest.squared_distance) continue;
    if (next.node >= leaves_) {
      look_in_leaf(next.node - leaves_, point, nearest);
      continue;
    }
    Waiting near = {2 * next.node, boxes_[2 * next.node].squared_distance(point)};
    Waiting far = {2 * next.node + 1, boxes_[2 * next.node + 1].squared_distance(point)};
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
  last_ = nearest.triangle;
  return std::max(std::sqrt(nearest.squared_distance), enough);
}

void BoxTree::look_in_leaf(std::size_t leaf, const Point& point, Nearest& nearest) const {
  for (std::size_t i = leaf * leaf_size; i < leaf_end(leaf); ++i) {
    const double away = squared_distance(point, triangle(i));
    if (away < nearest.squared_distance) nearest = {away, i};
  }
}

bool BoxTree::is_near(const Box& box) const {
  std::array<std::size_t, most_waiting> waiting;
  std::size_t count = 0;
  waiting[count++] = 1;
  while (count > 0) {
    const std::size_t node = waiting[--count];
    if (!boxes_[node].overlaps(box)) continue;
    if (node < leaves_) {
      waiting[count++] = 2 * node;
      waiting[count++] = 2 * node + 1;
      continue;
    }
    const std::size_t leaf = node - leaves_;
    for (std::size_t i = leaf * leaf_size; i < leaf_end(leaf); ++i)
      if (box.overlaps(Box(triangle(i)))) return true;
  }
  return false;
}

}  // namespace discmc::host
