#include "intersections.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>

#include "box_tree.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "jobs/parallel.hpp"
#include "triangle_intersection.hpp"

namespace discmc::meshing {
namespace {

Corners corners_of(const FaceMesh& mesh, const std::uint32_t* numbers) {
  return {mesh.vertices_mm[numbers[0]], mesh.vertices_mm[numbers[1]], mesh.vertices_mm[numbers[2]]};
}
Corners corners_of(const FaceMesh& mesh, std::uint32_t face) {
  return corners_of(mesh, mesh.face(face));
}

BoxTree tree_of(const FaceMesh& mesh, const FaceList& faces, unsigned jobs) {
  const auto corners = [&](std::uint32_t i) { return corners_of(mesh, faces[i]); };
  return BoxTree(boxes_of(faces.size(), corners, jobs), jobs);
}

// Faces in the order of their tree, so that compared ones are near each other in memory.
class OrderedFaces {
 public:
  OrderedFaces(const FaceMesh& mesh, const FaceList& faces, const BoxTree& tree, unsigned jobs)
      : mesh_(mesh), ordered_(faces.size()) {
    for_each_range_in_parallel(jobs, faces.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t at = first; at < end; ++at) {
        ordered_[at].face = faces[tree.index_at(at)];
        std::copy_n(mesh.face(ordered_[at].face), 3, ordered_[at].numbers.begin());
      }
    });
  }

  std::uint32_t face(std::uint32_t at) const { return ordered_[at].face; }
  const std::uint32_t* numbers(std::uint32_t at) const { return ordered_[at].numbers.data(); }
  PlacedTriangle triangle(std::uint32_t at) const {
    return {numbers(at), corners_of(mesh_, numbers(at))};
  }

 private:
  struct Ordered {
    std::array<std::uint32_t, 3> numbers;
    std::uint32_t face;
  };

  const FaceMesh& mesh_;
  std::vector<Ordered> ordered_;
};

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
  const OrderedFaces ordered(mesh, faces, tree, jobs);
  std::vector<FacePair> pairs;
  run_in_order<std::vector<FacePair>>(
      jobs, tree.part_count(), [](std::size_t, std::vector<FacePair>& found) { found.clear(); },
      [&](std::size_t number, std::vector<FacePair>& found) {
        std::optional<ComparedTriangle> compared;
        tree.for_each_near_pair(number, [&](std::uint32_t at, std::uint32_t other) {
          if (count_shared(ordered.numbers(at), ordered.numbers(other)) > 1) return;  // an edge
          if (!compared || compared->numbers != ordered.numbers(at))
            compared.emplace(ordered.triangle(at));
          if (!intersect(*compared, ordered.triangle(other))) return;
          const std::uint32_t a = ordered.face(at), b = ordered.face(other);
          found.push_back({std::min(a, b), std::max(a, b)});
        });
      },
      [&](std::size_t, const std::vector<FacePair>& found) {
        if (check) check();
        pairs.insert(pairs.end(), found.begin(), found.end());
      });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace discmc::meshing
