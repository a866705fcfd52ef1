#include "intersections.hpp"

#include <algorithm>
#include <cstddef>

#include "box_tree.hpp"

namespace discmc::host {
namespace {

// The plane of a triangle.
class Plane {
 public:
  explicit Plane(const Corners& corners)
      : origin_(corners[0]),
        normal_(cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]))),
        squared_length_(dot(normal_, normal_)) {}

  // The side that a point is on: 1, -1, or 0 for in the plane, but for what rounding leaves unsure.
  int side_of(const Point& point) const {
    const Point away = difference(point, origin_);
    const double height = dot(normal_, away);
    constexpr double unsure = 1e-20;
    if (height * height <= unsure * squared_length_ * dot(away, away)) return 0;
    return height > 0 ? 1 : -1;
  }

 private:
  Point origin_, normal_;
  double squared_length_;
};

// Whether the line through two points on different sides of a triangle's plane meets the triangle.
bool meets(const Point& begin, const Point& end, const Corners& triangle) {
  int least = 1, most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = Plane({begin, end, triangle[i]}).side_of(triangle[(i + 1) % 3]);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return least >= 0 || most <= 0;
}

using Numbers = std::array<std::uint32_t, 3>;

// Faces of a mesh.
class Triangles {
 public:
  explicit Triangles(const Mesh& mesh) : mesh_(mesh) {}

  Corners corners(std::uint32_t face) const { return corners(numbers(face)); }

  std::vector<Corners> corners(const FaceList& faces) const {
    std::vector<Corners> result;
    result.reserve(faces.size());
    for (const std::uint32_t face : faces) result.push_back(corners(face));
    return result;
  }

  bool intersect(std::uint32_t one, std::uint32_t other) const {
    const Numbers a = numbers(one), b = numbers(other);
    if (count_shared(a, b) >= 2) return false;
    const Sides of_a = sides(a, b);
    if (are_all(1, of_a) || are_all(-1, of_a)) return false;
    const Sides of_b = sides(b, a);
    if (are_all(1, of_b) || are_all(-1, of_b)) return false;
    return goes_through(a, of_a, b) || goes_through(b, of_b, a);
  }

 private:
  using Sides = std::array<int, 3>;
  static constexpr int shared = 2;

  Numbers numbers(std::uint32_t face) const {
    const std::uint32_t* corners = mesh_.face(face);
    return {corners[0], corners[1], corners[2]};
  }
  Corners corners(const Numbers& numbers) const {
    return {mesh_.vertices_mm[numbers[0]], mesh_.vertices_mm[numbers[1]],
            mesh_.vertices_mm[numbers[2]]};
  }

  static bool has(const Numbers& numbers, std::uint32_t number) {
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  }
  static std::size_t count_shared(const Numbers& a, const Numbers& b) {
    return static_cast<std::size_t>(
        std::count_if(a.begin(), a.end(), [&b](std::uint32_t number) { return has(b, number); }));
  }

  // Of the vertices of a, the side of the plane of b that each is on, or that b has it.
  Sides sides(const Numbers& a, const Numbers& b) const {
    const Plane plane(corners(b));
    Sides sides{};
    for (std::size_t i = 0; i < 3; ++i)
      sides[i] = has(b, a[i]) ? shared : plane.side_of(mesh_.vertices_mm[a[i]]);
    return sides;
  }
  static bool are_all(int side, const Sides& sides) {
    return std::all_of(sides.begin(), sides.end(),
                       [side](int each) { return each == side || each == shared; });
  }

  // Whether an edge of a that has no vertex of b meets b.
  bool goes_through(const Numbers& a, const Sides& of_a, const Numbers& b) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (of_a[i] == shared || of_a[next] == shared || of_a[i] == of_a[next]) continue;
      if (meets(mesh_.vertices_mm[a[i]], mesh_.vertices_mm[a[next]], corners(b))) return true;
    }
    return false;
  }

  const Mesh& mesh_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> intersecting_faces(const Mesh& mesh,
                                                             const FaceList& faces) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  if (faces.empty()) return pairs;
  const Triangles triangles(mesh);
  const std::vector<Corners> corners = triangles.corners(faces);
  BoxTree(corners).for_each_near_pair([&](std::uint32_t one, std::uint32_t other) {
    if (triangles.intersect(faces[one], faces[other])) pairs.push_back({faces[one], faces[other]});
  });
  return pairs;
}

FaceList near_faces(const Mesh& mesh, const FaceList& faces) {
  FaceList near;
  if (faces.empty()) return near;
  const Triangles triangles(mesh);
  const std::vector<Corners> corners = triangles.corners(faces);
  const BoxTree tree(corners);
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face)
    if (tree.is_near(Box(triangles.corners(face)))) near.push_back(face);
  return near;
}

}  // namespace discmc::host
