#include "intersections.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

#include "box_tree.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "jobs/parallel.hpp"
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

bool intersect(const FaceMesh& mesh, const ComparedTriangle& compared, std::uint32_t other) {
  const bool share_an_edge = count_shared(compared.numbers, mesh.face(other)) > 1;
  return !share_an_edge && intersect(compared, placed(mesh, other));
}

BoxTree tree_of(const FaceMesh& mesh, const FaceList& faces, unsigned jobs) {
  const auto corners = [&](std::uint32_t i) { return corners_of(mesh, faces[i]); };
  return BoxTree(boxes_of(faces.size(), corners, jobs), jobs);
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
  BoxTree tree = tree_of(mesh, faces, jobs);
  if (!is_wanted.empty())
    tree.keep_pairs_with([&](std::uint32_t index) { return is_wanted[faces[index]]; });
  std::vector<FacePair> pairs;
  run_in_order<std::vector<FacePair>>(
      jobs, tree.part_count(), [](std::size_t, std::vector<FacePair>& found) { found.clear(); },
      [&](std::size_t number, std::vector<FacePair>& found) {
        std::optional<ComparedTriangle> compared;
        tree.for_each_near_pair(number, [&](std::uint32_t index, std::uint32_t other_index) {
          const std::uint32_t face = faces[index], other = faces[other_index];
          if (!compared || compared->numbers != mesh.face(face))
            compared.emplace(placed(mesh, face));
          if (intersect(mesh, *compared, other))
            found.push_back({std::min(face, other), std::max(face, other)});
        });
      },
      [&](std::size_t, const std::vector<FacePair>& found) {
        if (check) check();
        pairs.insert(pairs.end(), found.begin(), found.end());
      });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

FaceList near_faces(const FaceMesh& mesh, const FaceList& faces, unsigned jobs) {
  const BoxTree tree = tree_of(mesh, faces, jobs);
  std::vector<std::uint8_t> is_near(mesh.face_count());
  for_each_range_in_parallel(jobs, is_near.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t face = first; face < end; ++face)
      is_near[face] = tree.any_near(Box(corners_of(mesh, static_cast<std::uint32_t>(face))),
                                    [](std::uint32_t, const Box&) { return true; });
  });
  FaceList near;
  for (std::uint32_t face = 0; face < is_near.size(); ++face)
    if (is_near[face] != 0) near.push_back(face);
  return near;
}

}  // namespace discmc::meshing
