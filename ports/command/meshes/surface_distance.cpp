#include "surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "point_distance.hpp"

namespace discmc::host {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Corners = std::array<Point, 3>;

Point divided(const Point& point, const Point& unit) {
  return {point[0] / unit[0], point[1] / unit[1], point[2] / unit[2]};
}

std::vector<Corners> triangles_of(const Mesh& mesh, const Point& unit) {
  std::vector<Corners> triangles;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t* corners = mesh.face(face);
    const auto at = [&](std::size_t i) { return divided(mesh.vertices_mm[corners[i]], unit); };
    for (std::size_t i = 2; i < mesh.face_size(face); ++i)
      triangles.push_back({at(0), at(i - 1), at(i)});
  }
  if (triangles.empty()) throw std::invalid_argument("a mesh without faces has no distance");
  return triangles;
}

double area(const Corners& triangle) {
  const Point doubled =
      cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
  return std::hypot(doubled[0], doubled[1], doubled[2]) / 2;
}

struct Box {
  Point low{infinity, infinity, infinity};
  Point high{-infinity, -infinity, -infinity};

  void include(const Point& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  void include(const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], box.low[axis]);
      high[axis] = std::max(high[axis], box.high[axis]);
    }
  }
  double squared_distance(const Point& point) const {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double away = std::max({low[axis] - point[axis], point[axis] - high[axis], 0.0});
      sum += away * away;
    }
    return sum;
  }
};

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

// Finds the nearest triangle: a binary tree of boxes around triangles that are near to each other.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Corners>& triangles) {
    Box all;
    for (const Corners& triangle : triangles)
      for (const Point& corner : triangle) all.include(corner);
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      order.emplace_back(place_on_curve(triangles[i], all), i);
    std::sort(order.begin(), order.end());
    for (const auto& place : order) triangles_.push_back(triangles[place.second]);

    while (leaves_ * leaf_size < triangles_.size()) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (const Point& corner : triangles_[i]) boxes_[leaves_ + i / leaf_size].include(corner);
    for (std::size_t node = leaves_ - 1; node > 0; --node) {
      boxes_[node] = boxes_[2 * node];
      boxes_[node].include(boxes_[2 * node + 1]);
    }
  }

  /// The distance of a point, or `enough` where it is no more. It takes less time the nearer the
  /// point is to the one before.
  double distance(const Point& point, double enough = 0) {
    const double squared_enough = enough * enough;
    Nearest nearest{squared_distance(point, triangles_[last_]), last_};
    std::array<Waiting, 128> waiting;  // the tree has at most 64 levels
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

 private:
  static constexpr std::size_t leaf_size = 4;

  struct Nearest {
    double squared_distance;
    std::size_t triangle;
  };
  struct Waiting {
    std::size_t node;
    double squared_distance;
  };

  void look_in_leaf(std::size_t leaf, const Point& point, Nearest& nearest) const {
    const std::size_t end = std::min((leaf + 1) * leaf_size, triangles_.size());
    for (std::size_t i = leaf * leaf_size; i < end; ++i) {
      const double away = squared_distance(point, triangles_[i]);
      if (away < nearest.squared_distance) nearest = {away, i};
    }
  }

  std::vector<Corners> triangles_;
  std::size_t leaves_ = 1;
  std::vector<Box> boxes_;  // node i has the children 2 i and 2 i + 1; the leaves are the last ones
  std::size_t last_ = 0;    // the triangle that was found
};

// Points in a unit square that fill it evenly, however many (M. Roberts, 2018).
class EvenPoints {
 public:
  std::array<double, 2> next() {
    at_[0] = std::fmod(at_[0] + 0.7548776662466927, 1);
    at_[1] = std::fmod(at_[1] + 0.5698402909980532, 1);
    return at_;
  }

 private:
  std::array<double, 2> at_{0.5, 0.5};
};

Point point_in(const Corners& triangle, std::array<double, 2> at) {
  if (at[0] + at[1] > 1) at = {1 - at[0], 1 - at[1]};
  Point point = triangle[0];
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[axis] += at[0] * (triangle[1][axis] - triangle[0][axis]) +
                   at[1] * (triangle[2][axis] - triangle[0][axis]);
  return point;
}

}  // namespace

Distances distances(const Mesh& from, const Mesh& to, const Point& unit,
                    const std::function<void(std::size_t, std::size_t)>& progress,
                    std::size_t samples) {
  BoxTree tree(triangles_of(to, unit));
  const std::vector<Corners> triangles = triangles_of(from, unit);
  double whole_area = 0;
  for (const Corners& triangle : triangles) whole_area += area(triangle);
  if (!(whole_area > 0)) throw std::invalid_argument("a mesh without area has no distance");

  std::vector<double> measured;
  const std::size_t all = samples + from.corners.size();
  const auto show = [&](std::size_t done) {
    constexpr std::size_t step = 1024;
    if (progress && (done % step == 0 || done == all)) progress(done, all);
  };
  EvenPoints even_points;
  double due = 0.5;
  for (const Corners& triangle : triangles)
    for (due += area(triangle) / whole_area * static_cast<double>(samples); due >= 1; --due) {
      measured.push_back(tree.distance(point_in(triangle, even_points.next())));
      show(measured.size());
    }

  Distances result;
  std::sort(measured.begin(), measured.end());
  for (const double distance : measured)
    result.mean += distance / static_cast<double>(measured.size());
  if (!measured.empty()) {
    result.percentile_99 = measured[measured.size() * 99 / 100];
    result.largest = measured.back();
  }
  for (std::size_t i = 0; i < from.corners.size(); ++i) {
    const Point vertex = divided(from.vertices_mm[from.corners[i]], unit);
    result.largest = tree.distance(vertex, result.largest);
    show(samples + i + 1);
  }
  return result;
}

}  // namespace discmc::host
