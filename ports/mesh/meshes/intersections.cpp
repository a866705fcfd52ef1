#include "intersections.hpp"

#include <cstddef>

#include "box_tree.hpp"
#include "triangle_intersection.hpp"

namespace discmc::meshing {
namespace {

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
    const bool share_an_edge = count_shared(mesh_.face(faces_[one]), mesh_.face(faces_[other])) > 1;
    return !share_an_edge && meshing::intersect(placed(one), placed(other));
  }

 private:
  PlacedTriangle placed(std::size_t place) const {
    const std::uint32_t face = faces_[place];
    return {mesh_.face(face), corners_of(mesh_, face), normals_[place]};
  }

  const FaceMesh& mesh_;
  const FaceList& faces_;
  std::vector<TriangleNormal> normals_;
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
    if (tree.any_near(Box(corners_of(mesh, face)), [](std::uint32_t) { return true; }))
      near.push_back(face);
  return near;
}

}  // namespace discmc::meshing
