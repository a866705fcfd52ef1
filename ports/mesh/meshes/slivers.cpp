#include "slivers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "mesh_edges.hpp"

namespace discmc::meshing {
namespace {

// Cosines. Each collapse removes two triangles, so it is for the worst ones only.
constexpr double of_flips = 0.94;       // 20 degrees
constexpr double of_collapses = 0.996;  // 5 degrees
constexpr double hardly_turned = 0.87;  // 30 degrees
constexpr double less = 1e-9;           // so that rounding flips nothing there and back

Point normal_of(const Point& a, const Point& b, const Point& c) {
  return cross(difference(b, a), difference(c, a));
}

double cosine(const Point& a, const Point& b) {
  return dot(unit_or_zero(a), unit_or_zero(b));
}

// Of the smallest angle.
double cosine_of(const Point& a, const Point& b, const Point& c) {
  const Point ab = unit_or_zero(difference(b, a)), bc = unit_or_zero(difference(c, b)),
              ca = unit_or_zero(difference(a, c));
  return std::max({-dot(ab, bc), -dot(bc, ca), -dot(ca, ab)});
}

class SliverRemoval {
 public:
  SliverRemoval(FaceMesh& mesh, std::size_t first_faces, double max_distance_mm)
      : corners_(mesh.corners),
        vertices_(mesh.vertices_mm),
        max_distance_(max_distance_mm),
        twins_(mesh.corners.size(), no_side),
        is_fixed_(mesh.vertices_mm.size()) {
    for_each_edge(sorted_edges(mesh), [&](const FaceEdge* uses, std::size_t count) {
      edges_.insert(key(uses->low, uses->high));
      if (count == 2 && uses[0].falls != uses[1].falls && uses[0].face >= first_faces &&
          uses[1].face >= first_faces)
        link(side_of(uses[0]), side_of(uses[1]));
      else
        is_fixed_[uses->low] = is_fixed_[uses->high] = true;
    });
  }

  void flip() {
    for_each_thin(of_flips, [this](Side, Side longest) {
      if (!flip_if_better(longest) && !flip_if_better(next(longest)))
        flip_if_better(previous(longest));
    });
  }

  void collapse() {
    for_each_thin(of_collapses, [this](Side shortest, Side) {
      if (twins_[shortest] != no_side && !collapse_if_better(shortest))
        collapse_if_better(twins_[shortest]);
    });
    drop_gone();
  }

 private:
  // Side i of triangle t goes from its corner i to the next one and has the number 3 t + i.
  using Side = std::uint32_t;
  static constexpr Side no_side = 0xFFFFFFFFu;

  static Side next(Side side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Side previous(Side side) { return side % 3 == 0 ? side + 2 : side - 1; }

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  Side side_of(const FaceEdge& use) const {
    Side side = 3 * use.face;
    while (corners_[side] != (use.falls ? use.high : use.low)) ++side;
    return side;
  }
  const Point& at(Side side) const { return vertices_[corners_[side]]; }
  double squared_length(Side side) const {
    const Point along = difference(at(next(side)), at(side));
    return dot(along, along);
  }
  // Calls call(shortest side, longest side) for triangles whose smallest angle has a larger cosine,
  // and again for those that have changed since.
  template <class Call>
  void for_each_thin(double least_cosine, const Call& call) {
    for (std::uint32_t triangle = 0; triangle < corners_.size() / 3; ++triangle)
      waiting_.push_back(triangle);
    while (!waiting_.empty()) {
      const Side side = 3 * waiting_.back();
      waiting_.pop_back();
      if (is_gone(side) || cosine_of(at(side), at(side + 1), at(side + 2)) < least_cosine) continue;
      const auto [shortest, longest] =
          std::minmax({side, side + 1, side + 2},
                      [this](Side a, Side b) { return squared_length(a) < squared_length(b); });
      call(shortest, longest);
    }
  }

  bool is_gone(Side first) const { return corners_[first] == corners_[first + 1]; }
  void link(Side a, Side b) {
    if (a != no_side) twins_[a] = b;
    if (b != no_side) twins_[b] = a;
  }

  // The sides that leave its vertex, which has no fixed edge, within one part of the mesh.
  const std::vector<Side>& ring(Side side) {
    ring_.clear();
    for (Side leaving = side; ring_.empty() || leaving != side; leaving = twins_[previous(leaving)])
      ring_.push_back(leaving);
    return ring_;
  }

  // Of the triangles a b c and b a d it makes a d c and d b c.
  bool flip_if_better(Side side) {
    const Side twin = twins_[side];
    if (twin == no_side) return false;
    const std::uint32_t ia = corners_[side], ib = corners_[twin], ic = corners_[previous(side)],
                        id = corners_[previous(twin)];
    if (ic == id || edges_.count(key(ic, id)) > 0) return false;
    const Point &a = vertices_[ia], &b = vertices_[ib], &c = vertices_[ic], &d = vertices_[id];
    const double before = std::max(cosine_of(a, b, c), cosine_of(b, a, d));
    const double after = std::max(cosine_of(a, d, c), cosine_of(d, b, c));
    if (!(after < before - less)) return false;
    const Point one = normal_of(a, d, c), other = normal_of(d, b, c);
    const Point all = {one[0] + other[0], one[1] + other[1], one[2] + other[2]};
    if (cosine(one, all) < hardly_turned || cosine(other, all) < hardly_turned) return false;
    const Point across = unit_or_zero(cross(difference(b, a), difference(d, c)));
    if (!(std::abs(dot(across, difference(c, a))) <= max_distance_)) return false;
    const Side outer[] = {twins_[next(twin)], twins_[previous(twin)], twins_[next(side)],
                          twins_[previous(side)]};
    const Side first = side - side % 3, second = twin - twin % 3;
    set(first, ia, id, ic);
    set(second, id, ib, ic);
    link(first, outer[0]);
    link(second, outer[1]);
    link(second + 1, outer[2]);
    link(first + 2, outer[3]);
    link(first + 1, second + 2);
    edges_.erase(key(ia, ib));
    edges_.insert(key(ic, id));
    waiting_.insert(waiting_.end(), {first / 3, second / 3});
    for (const Side changed : outer)
      if (changed != no_side) waiting_.push_back(changed / 3);
    return true;
  }
  void set(Side first, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    corners_[first] = a;
    corners_[first + 1] = b;
    corners_[first + 2] = c;
  }

  // Moves the vertex where a side starts to its end.
  bool collapse_if_better(Side side) {
    const Side twin = twins_[side];
    if (is_fixed_[corners_[side]] || is_fixed_[corners_[twin]]) return false;
    const std::uint32_t from = corners_[side], to = corners_[twin];
    const Point target = vertices_[to], along = difference(target, vertices_[from]);
    double before = -1, after = -1;
    std::size_t common = 0;
    for (const Side leaving : ring(side)) {
      const Point &b = at(next(leaving)), &c = at(previous(leaving));
      if (edges_.count(key(corners_[next(leaving)], to)) > 0) ++common;
      before = std::max(before, cosine_of(at(leaving), b, c));
      if (corners_[next(leaving)] == to || corners_[previous(leaving)] == to) continue;
      after = std::max(after, cosine_of(target, b, c));
      const Point was = normal_of(at(leaving), b, c), is = normal_of(target, b, c);
      if (cosine(was, is) < hardly_turned) return false;
      if (!(std::abs(dot(unit_or_zero(was), along)) <= max_distance_)) return false;
    }
    if (common != 2 || ring_.size() < 4 || !(after < before - less)) return false;
    for (const Side leaving : ring_) {
      edges_.erase(key(from, corners_[next(leaving)]));
      if (corners_[next(leaving)] != to) edges_.insert(key(to, corners_[next(leaving)]));
    }
    for (const Side leaving : ring_) {
      corners_[leaving] = to;
      waiting_.push_back(leaving / 3);
    }
    for (const Side gone : {side, twin}) {
      link(twins_[next(gone)], twins_[previous(gone)]);
      set(gone - gone % 3, 0, 0, 0);
    }
    return true;
  }

  void drop_gone() {
    std::size_t left = 0;
    for (Side first = 0; first < corners_.size(); first += 3) {
      if (is_gone(first)) continue;
      for (Side side = first; side < first + 3; ++side) corners_[left++] = corners_[side];
    }
    corners_.resize(left);
  }

  std::vector<std::uint32_t>& corners_;
  const std::vector<Point>& vertices_;
  const double max_distance_;
  std::vector<Side> twins_;     // of every side the other one between the same points
  std::vector<bool> is_fixed_;  // vertices
  std::unordered_set<std::uint64_t> edges_;
  std::vector<std::uint32_t> waiting_;  // triangles to be looked at
  std::vector<Side> ring_;
};

}  // namespace

void remove_slivers(FaceMesh& mesh, std::size_t first_faces, double max_distance_mm) {
  SliverRemoval removal(mesh, first_faces, max_distance_mm);
  removal.flip();
  removal.collapse();
  mesh.face_begin.resize(mesh.corners.size() / 3 + 1);
}

}  // namespace discmc::meshing
