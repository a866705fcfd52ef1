#include "intersections.hpp"

#include <algorithm>
#include <cstddef>

#include "box_tree.hpp"

namespace discmc::meshing {
namespace {

// The normal of a triangle.
class Normal {
 public:
  explicit Normal(const Corners& triangle)
      : normal_(cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]))),
        squared_length_(dot(normal_, normal_)) {}

  // The side that a point is on of the plane through the origin: 1, -1, or 0 for in the plane, but
  // for what rounding leaves unsure.
  int side_of(const Point& origin, const Point& point) const {
    const Point away = difference(point, origin);
    const double height = dot(normal_, away);
    constexpr double unsure = 1e-20;
    const int is_sure = height * height > unsure * squared_length_ * dot(away, away);
    return is_sure * ((height > 0) - (height < 0));
  }

 private:
  Point normal_;
  double squared_length_;
};

// Whether the line through two points on different sides of a triangle's plane meets the triangle.
bool meets(const Point& begin, const Point& end, const Corners& triangle) {
  int least = 0, most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = Normal({begin, end, triangle[i]}).side_of(begin, triangle[(i + 1) % 3]);
    least = std::min(least, side);
    most = std::max(most, side);
    if (least < 0 && most > 0) return false;
  }
  return true;
}

// For each of the three vertices of a face, whether another face has it, too.
using Shared = std::array<bool, 3>;

// The side of a plane that each of the three is on.
using Sides = std::array<int, 3>;

bool are_two(const Shared& shared) {
  return shared[0] + shared[1] + shared[2] >= 2;
}

// Whether all that are not shared are on one side. As Box::overlaps() without branches.
bool are_apart(const Sides& sides, const Shared& shared) {
  int not_above = 0, not_below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    not_above += !shared[i] * (sides[i] <= 0);
    not_below += !shared[i] * (sides[i] >= 0);
  }
  return not_above == 0 || not_below == 0;
}

Corners corners_of(const FaceMesh& mesh, std::uint32_t face) {
  const std::uint32_t* numbers = mesh.face(face);
  return {mesh.vertices_mm[numbers[0]], mesh.vertices_mm[numbers[1]], mesh.vertices_mm[numbers[2]]};
}

// Some faces of a mesh.
class SomeFaces {
 public:
  SomeFaces(const FaceMesh& mesh, const FaceList& faces) : mesh_(mesh), faces_(faces) {
    normals_.reserve(faces.size());
    for (const std::uint32_t face : faces) normals_.emplace_back(corners_of(mesh, face));
  }

  // Whether two faces intersect. one, other: places in the list.
  bool intersect(std::size_t one, std::size_t other) const {
    const std::uint32_t* const a = mesh_.face(faces_[one]);
    const std::uint32_t* const b = mesh_.face(faces_[other]);
    Shared of_a{}, of_b{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const bool is_same = a[i] == b[j];
        of_a[i] |= is_same;
        of_b[j] |= is_same;
      }
    if (are_two(of_a)) return false;
    const Corners corners_of_a = corners_of(mesh_, faces_[one]);
    const Corners corners_of_b = corners_of(mesh_, faces_[other]);
    const Sides sides_of_a = sides(corners_of_a, corners_of_b[0], normals_[other]);
    if (are_apart(sides_of_a, of_a)) return false;
    const Sides sides_of_b = sides(corners_of_b, corners_of_a[0], normals_[one]);
    if (are_apart(sides_of_b, of_b)) return false;
    return goes_through(corners_of_a, sides_of_a, of_a, corners_of_b) ||
           goes_through(corners_of_b, sides_of_b, of_b, corners_of_a);
  }

 private:
  static Sides sides(const Corners& corners, const Point& origin, const Normal& normal) {
    return {normal.side_of(origin, corners[0]), normal.side_of(origin, corners[1]),
            normal.side_of(origin, corners[2])};
  }

  // Whether an edge of a that has no vertex of b meets b.
  static bool goes_through(const Corners& a, const Sides& sides, const Shared& shared,
                           const Corners& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (shared[i] || shared[next] || sides[i] == sides[next]) continue;
      if (meets(a[i], a[next], b)) return true;
    }
    return false;
  }

  const FaceMesh& mesh_;
  const FaceList& faces_;
  std::vector<Normal> normals_;
};

std::vector<Box> boxes_of(const FaceMesh& mesh, const FaceList& faces) {
  std::vector<Box> boxes;
  boxes.reserve(faces.size());
  for (const std::uint32_t face : faces) boxes.emplace_back(corners_of(mesh, face));
  return boxes;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> intersecting_faces(const FaceMesh& mesh,
                                                             const FaceList& faces,
                                                             const std::function<void()>& check) {
  constexpr std::uint64_t pairs_a_check = 1 << 16;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const SomeFaces some(mesh, faces);
  const BoxTree tree(boxes_of(mesh, faces));
  std::uint64_t tried = 0;
  tree.for_each_near_pair([&](std::uint32_t one, std::uint32_t other) {
    if (check && ++tried % pairs_a_check == 0) check();
    if (some.intersect(one, other)) pairs.push_back({faces[one], faces[other]});
  });
  return pairs;
}

FaceList near_faces(const FaceMesh& mesh, const FaceList& faces) {
  FaceList near;
  const BoxTree tree(boxes_of(mesh, faces));
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face)
    if (tree.is_near(Box(corners_of(mesh, face)))) near.push_back(face);
  return near;
}

}  // namespace discmc::meshing
