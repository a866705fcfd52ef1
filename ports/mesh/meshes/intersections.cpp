#include "intersections.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

#include "box_tree.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "triangle_intersection.hpp"

namespace discmc::meshing {
namespace {

Corners corners_of(const FaceMesh& mesh, std::uint32_t face) {
  const std::uint32_t* numbers = mesh.face(face);
  return {mesh.vertices_mm[numbers[0]], mesh.vertices_mm[numbers[1]], mesh.vertices_mm[numbers[2]]};
}

PlacedTriangle placed(const FaceMesh& mesh, std::uint32_t face) {
  return {mesh.face(face), corners_of(mesh, face)};
}

bool intersect(const FaceMesh& mesh, const ComparedTriangle& one, std::uint32_t other) {
  const bool share_an_edge = count_shared(one.numbers, mesh.face(other)) > 1;
  return !share_an_edge && intersect(one, placed(mesh, other));
}

std::vector<Box> boxes_of(const FaceMesh& mesh, const FaceList& faces) {
  return meshing::boxes_of(faces.size(),
                           [&](std::uint32_t i) { return corners_of(mesh, faces[i]); });
}

}  // namespace

FaceList all_faces(const FaceMesh& mesh) {
  FaceList faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), 0U);
  return faces;
}

std::vector<FacePair> intersecting_faces(const FaceMesh& mesh, const FaceList& faces,
                                         const std::function<void()>& check, unsigned jobs,
                                         const std::vector<bool>& is_wanted) {
  BoxTree tree(boxes_of(mesh, faces));
  if (!is_wanted.empty())
    tree.keep_pairs_with([&](std::uint32_t place) { return is_wanted[faces[place]]; });
  std::vector<FacePair> pairs;
  run_in_order<std::vector<FacePair>>(
      jobs, tree.part_count(), [](std::size_t, std::vector<FacePair>& found) { found.clear(); },
      [&](std::size_t number, std::vector<FacePair>& found) {
        std::optional<ComparedTriangle> compared;
        tree.for_each_near_pair(number, [&](std::uint32_t place, std::uint32_t other_place) {
          const std::uint32_t one = faces[place], other = faces[other_place];
          if (!compared || compared->numbers != mesh.face(one)) compared.emplace(placed(mesh, one));
          if (intersect(mesh, *compared, other))
            found.push_back({std::min(one, other), std::max(one, other)});
        });
      },
      [&](std::size_t, const std::vector<FacePair>& found) {
        if (check) check();
        pairs.insert(pairs.end(), found.begin(), found.end());
      });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

FaceList near_faces(const FaceMesh& mesh, const FaceList& faces) {
  FaceList near;
  const BoxTree tree(boxes_of(mesh, faces));
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face)
    if (tree.any_near(Box(corners_of(mesh, face)), [](std::uint32_t, const Box&) { return true; }))
      near.push_back(face);
  return near;
}

}  // namespace discmc::meshing
