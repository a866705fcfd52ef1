#include "intersections.hpp"

#include <cstddef>

#include "box_tree.hpp"
#include "jobs/ordered_pipeline.hpp"
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

std::vector<FacePair> intersecting_faces(const FaceMesh& mesh, const FaceList& faces,
                                         const std::function<void()>& check, unsigned jobs,
                                         const std::vector<bool>& is_wanted) {
  const SomeFaces some(mesh, faces);
  BoxTree tree(boxes_of(mesh, faces));
  if (!is_wanted.empty())
    tree.keep_pairs_with([&](std::uint32_t place) { return is_wanted[faces[place]]; });
  const std::vector<BoxTree::NodePair> parts = tree.parts();
  std::vector<FacePair> pairs;
  run_in_order<std::vector<FacePair>>(
      jobs, parts.size(), [](std::size_t, std::vector<FacePair>& found) { found.clear(); },
      [&](std::size_t number, std::vector<FacePair>& found) {
        tree.for_each_near_pair(parts[number], [&](std::uint32_t one, std::uint32_t other) {
          if (some.intersect(one, other)) found.push_back({faces[one], faces[other]});
        });
      },
      [&](std::size_t, const std::vector<FacePair>& found) {
        if (check) check();
        pairs.insert(pairs.end(), found.begin(), found.end());
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
