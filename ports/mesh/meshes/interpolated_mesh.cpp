#include "interpolated_mesh.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <utility>

#include "box_tree.hpp"
#include "intersections.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "jobs/parallel.hpp"
#include "outline.hpp"
#include "refinement.hpp"

namespace discmc::meshing {
namespace {

// The faces of all polygons, before some of them are renewed.
struct EarlierFaces {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> polygons;   // one per face, ascending
  std::vector<bool> leaves_out;          // one per face, as in MovedTriangles
  std::vector<bool> is_outdated;         // one per polygon
  std::vector<std::uint8_t> may_change;  // one per polygon: whether a side may have a new vertex
  std::size_t first_new;                 // vertices from this number on are new
};

// The faces of a block of polygons.
struct BlockFaces {
  void clear() {
    corners.clear();
    polygons.clear();
    leaves_out.clear();
    renewed.clear();
    left_out.clear();
    added.clear();
  }

  std::vector<std::uint32_t> corners;   // numbers of vertices; beyond them, of `added`
  std::vector<std::uint32_t> polygons;  // one per face
  std::vector<bool> leaves_out;         // one per face, as in MovedTriangles
  std::vector<std::uint32_t> renewed;   // indexes of faces
  std::vector<std::uint32_t> left_out;  // as in FaceMesh
  std::vector<Vertex> added;            // vertices without a number
};

// Finds vertices and makes faces for the polygons of a block. Each thread needs its own object.
class BlockRefiner {
 public:
  // moved: the new positions of vertices. Owner: the caller keeps all.
  BlockRefiner(const Surface& surface, const VertexNumbers& vertices,
               const std::vector<Point>& moved, const MeshingOptions& options)
      : surface_(surface),
        vertices_(vertices),
        moved_(moved),
        is_mirrored_(is_mirrored(surface.spacing_mm)),
        outline_(vertices, true),
        refinement_(*options.crossings, options.tolerance) {}

  // Finds the crossings that interpolated sides need as junctions, for both polygons of each side.
  void find_needed(std::size_t block, std::vector<Vertex>& needed) {
    needed.clear();
    const PolygonSpan span = block_of(surface_.polygons, block);
    for (std::size_t polygon = span.first; polygon < span.end; ++polygon)
      for (const Ring& ring : surface_.polygons[polygon].rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          add_needed(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], needed);
  }

  // Makes new triangles for outdated polygons, and for polygons with a new vertex on a side. Other
  // polygons keep their earlier ones.
  void make_faces(std::size_t block, const EarlierFaces& earlier, BlockFaces& faces) {
    faces.clear();
    const PolygonSpan span = block_of(surface_.polygons, block);
    auto end = static_cast<std::size_t>(
        std::lower_bound(earlier.polygons.begin(), earlier.polygons.end(), span.first) -
        earlier.polygons.begin());
    for (std::size_t i = span.first; i < span.end; ++i) {
      const auto polygon = static_cast<std::uint32_t>(i);
      const std::size_t begin = end;
      while (end < earlier.polygons.size() && earlier.polygons[end] == polygon) ++end;
      if (earlier.is_outdated[polygon] || earlier.may_change[polygon] != 0) {
        outline_.follow(surface_.polygons[polygon]);
        outline_.find_numbers();
        if (earlier.is_outdated[polygon] || has_vertex_from(earlier.first_new)) {
          add_polygon(polygon, faces);
          continue;
        }
      }
      if (begin == end) faces.left_out.push_back(polygon);
      for (std::size_t face = begin; face < end; ++face)
        add_face(polygon, earlier.corners.data() + 3 * face, earlier.leaves_out[face], faces);
    }
  }

 private:
  bool has_vertex_from(std::size_t number) const {
    return std::any_of(outline_.numbers.begin(), outline_.numbers.end(),
                       [number](std::uint32_t each) { return each >= number; });
  }

  // Splits the side at its junctions, and adds what each part needs.
  void add_needed(const Vertex& from, const Vertex& to, std::vector<Vertex>& needed) {
    if (links_between(from, to) < 2) return;
    const Side side = side_between(from, to);
    side_ = {from};
    for (std::int32_t i = 1; i <= side.links; ++i) {
      const Vertex vertex = side_.back() + side.link;
      side_.push_back(vertex);
      if (!vertices_.has(vertex)) continue;
      if (precedes(side_.back(), side_.front())) std::reverse(side_.begin(), side_.end());
      for (const std::size_t index : refinement_.needed(side_)) needed.push_back(side_[index]);
      side_ = {vertex};
    }
  }

  void add_polygon(std::uint32_t polygon, BlockFaces& faces) {
    const std::vector<Triangle>& triangles =
        triangulator_.triangulate(outline_, surface_.polygons[polygon].incidence);
    if (triangles.empty()) return faces.left_out.push_back(polygon);
    std::vector<std::uint32_t>& numbers = outline_.numbers;
    refined_.points = triangulator_.points();
    refined_.moved.clear();
    for (const std::uint32_t number : numbers) refined_.moved.push_back(moved_[number]);
    refined_.triangles = triangles;
    refinement_.refine(triangulator_.plane(), vertices_, refined_);
    for (std::size_t i = numbers.size(); i < refined_.points.size(); ++i)
      numbers.push_back(number_of(triangulator_.plane().vertex(refined_.points[i]), faces));
    const std::size_t first = faces.polygons.size();
    for (std::size_t index = 0; index < refined_.triangles.size(); ++index) {
      const Triangle& triangle = refined_.triangles[index];
      std::array<std::uint32_t, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = numbers[triangle[is_mirrored_ ? 2 - i : i]];
      add_face(polygon, corners.data(), refined_.leaves_out[index], faces);
    }
    for (std::size_t face = first; face < faces.polygons.size(); ++face)
      faces.renewed.push_back(static_cast<std::uint32_t>(face));
  }

  std::uint32_t number_of(const Vertex& vertex, BlockFaces& faces) const {
    const std::uint32_t number = vertices_.find(vertex);
    if (number != VertexNumbers::none) return number;
    faces.added.push_back(vertex);
    return static_cast<std::uint32_t>(moved_.size() + faces.added.size() - 1);
  }

  static void add_face(std::uint32_t polygon, const std::uint32_t* corners, bool leaves_out,
                       BlockFaces& faces) {
    faces.corners.insert(faces.corners.end(), corners, corners + 3);
    faces.polygons.push_back(polygon);
    faces.leaves_out.push_back(leaves_out);
  }

  const Surface& surface_;
  const VertexNumbers& vertices_;
  const std::vector<Point>& moved_;
  bool is_mirrored_;
  Outline outline_;  // of the current polygon
  OutlineTriangulator triangulator_;
  Refinement refinement_;
  std::vector<Vertex> side_;  // of the current part of a side
  MovedTriangles refined_;
};

class InterpolatedMesh {
 public:
  InterpolatedMesh(const Surface& surface, VertexNumbers vertices, const MeshingOptions& options)
      : surface_(surface), options_(options), vertices_(std::move(vertices)) {}

  FaceMesh build() {
    mesh_.spacing_mm = surface_.spacing_mm;
    mesh_.lattice = vertices_.positions(options_.jobs);
    number_needed_crossings();
    place_vertices();
    FaceList faces =
        make_faces(std::vector<bool>(surface_.polygons.size(), true), mesh_.lattice.size());
    if (options_.separates) separate_faces(std::move(faces));
    return std::move(mesh_);
  }

 private:
  template <class Item>
  struct Block {
    std::unique_ptr<BlockRefiner> refiner;
    Item result;
  };

  // Calls work(refiner, block, item) for all blocks in parallel, and consume(item) in order.
  template <class Item, class Work, class Consume>
  void for_each_block(Work work, Consume consume) {
    run_in_order<Block<Item>>(
        options_.jobs, block_count(surface_.polygons),
        [this](std::size_t, Block<Item>& block) {
          if (block.refiner == nullptr)
            block.refiner = std::make_unique<BlockRefiner>(surface_, vertices_, moved_, options_);
        },
        [&](std::size_t number, Block<Item>& block) { work(*block.refiner, number, block.result); },
        [&](std::size_t, const Block<Item>& block) {
          if (options_.check) options_.check();
          consume(block.result);
        });
  }

  void number_needed_crossings() {
    std::vector<Vertex> needed;
    for_each_block<std::vector<Vertex>>(
        [](BlockRefiner& refiner, std::size_t block, std::vector<Vertex>& block_needed) {
          refiner.find_needed(block, block_needed);
        },
        [&needed](const std::vector<Vertex>& block_needed) {
          needed.insert(needed.end(), block_needed.begin(), block_needed.end());
        });
    for (const Vertex& vertex : needed) add_vertex(vertex);
  }

  std::uint32_t add_vertex(const Vertex& vertex) {
    const std::uint32_t number = vertices_.add(vertex);
    if (number == mesh_.lattice.size()) mesh_.lattice.push_back(vertex);
    return number;
  }

  // Places the vertices that were added since the last call.
  void place_vertices() {
    const std::size_t placed = moved_.size(), vertex_count = mesh_.lattice.size();
    moved_.resize(vertex_count);
    mesh_.vertices_mm.resize(vertex_count);
    for_each_range_in_parallel(options_.jobs, vertex_count - placed,
                               [&](std::size_t first, std::size_t end) {
                                 for (std::size_t i = placed + first; i < placed + end; ++i) {
                                   moved_[i] = options_.crossings->interpolated(mesh_.lattice[i]);
                                   mesh_.vertices_mm[i] = in_mm(moved_[i], surface_.spacing_mm);
                                 }
                               });
  }

  // Makes the faces of outdated polygons, and of polygons with a new vertex on a side. Returns the
  // indexes of these faces.
  FaceList make_faces(std::vector<bool> is_outdated, std::size_t first_new) {
    std::vector<Box> new_vertices;
    for (std::size_t i = first_new; i < mesh_.lattice.size(); ++i)
      new_vertices.push_back(box_of(mesh_.lattice[i], mesh_.lattice[i]));
    const EarlierFaces earlier{std::exchange(mesh_.corners, {}), std::exchange(mesh_.polygons, {}),
                               std::exchange(leaves_out_, {}),   std::move(is_outdated),
                               polygons_near(new_vertices),      first_new};
    mesh_.left_out.clear();
    reserve_faces(mesh_, mesh_.lattice.size());
    FaceList renewed;
    std::vector<Vertex> added;
    for_each_block<BlockFaces>(
        [&earlier](BlockRefiner& refiner, std::size_t block, BlockFaces& faces) {
          refiner.make_faces(block, earlier, faces);
        },
        [&](const BlockFaces& faces) { append(faces, renewed, added); });
    mesh_.face_begin.resize(mesh_.polygons.size() + 1);
    for (std::size_t face = 0; face < mesh_.face_begin.size(); ++face)
      mesh_.face_begin[face] = 3 * face;
    number_added(added);
    return renewed;
  }

  void append(const BlockFaces& faces, FaceList& renewed, std::vector<Vertex>& added) {
    const auto first_face = static_cast<std::uint32_t>(mesh_.polygons.size());
    const auto first_added = static_cast<std::uint32_t>(added.size());
    const std::size_t numbered = moved_.size();
    const auto corners =
        mesh_.corners.insert(mesh_.corners.end(), faces.corners.begin(), faces.corners.end());
    std::for_each(corners, mesh_.corners.end(), [numbered, first_added](std::uint32_t& corner) {
      corner += corner < numbered ? 0 : first_added;
    });
    mesh_.polygons.insert(mesh_.polygons.end(), faces.polygons.begin(), faces.polygons.end());
    leaves_out_.insert(leaves_out_.end(), faces.leaves_out.begin(), faces.leaves_out.end());
    const auto faces_renewed =
        renewed.insert(renewed.end(), faces.renewed.begin(), faces.renewed.end());
    std::for_each(faces_renewed, renewed.end(),
                  [first_face](std::uint32_t& face) { face += first_face; });
    mesh_.left_out.insert(mesh_.left_out.end(), faces.left_out.begin(), faces.left_out.end());
    added.insert(added.end(), faces.added.begin(), faces.added.end());
  }

  // Numbers the vertices that faces have added, in place of their indexes.
  void number_added(const std::vector<Vertex>& added) {
    const std::size_t numbered = moved_.size();
    std::vector<std::uint32_t> numbers;
    numbers.reserve(added.size());
    for (const Vertex& vertex : added) numbers.push_back(add_vertex(vertex));
    for (std::uint32_t& corner : mesh_.corners)
      if (corner >= numbered) corner = numbers[corner - numbered];
    place_vertices();
  }

  // Triangles that leave out crossings may intersect where two sheets are near each other. Such
  // triangles get their crossings, until no such pair is left. Other intersecting pairs belong to
  // the interpolated surface itself, and stay.
  void separate_faces(FaceList faces) {
    for (;;) {
      const std::size_t vertices = mesh_.lattice.size();
      std::vector<bool> is_outdated(surface_.polygons.size());
      for (const auto& pair :
           intersecting_faces(mesh_, faces, options_.check, options_.jobs, leaves_out_))
        for (const std::uint32_t face : pair)
          if (number_crossings(face)) is_outdated[mesh_.polygons[face]] = true;
      if (mesh_.lattice.size() == vertices) return;
      place_vertices();
      faces = faces_near(make_faces(std::move(is_outdated), vertices));
    }
  }

  static Box box_of(const Vertex& low, const Vertex& high) {
    return Box({point_of(low), point_of(high), point_of(high)});
  }

  // Returns, for each polygon, whether the box of its vertices before they moved overlaps one of
  // the boxes. Units: half-steps.
  std::vector<std::uint8_t> polygons_near(const std::vector<Box>& boxes) const {
    std::vector<std::uint8_t> are_near(surface_.polygons.size());
    if (boxes.empty()) return are_near;
    const BoxTree tree(boxes);
    for_each_range_in_parallel(
        options_.jobs, are_near.size(), [&](std::size_t first, std::size_t end) {
          for (std::size_t i = first; i < end; ++i) {
            const Ring corners = surface_.polygons[i].rings.corners();
            const VertexBox box = box_around(corners.begin(), corners.end());
            are_near[i] = tree.any_near(box_of(box.low, box.high),
                                        [](std::uint32_t, const Box&) { return true; });
          }
        });
    return are_near;
  }

  // Returns all faces of each polygon that may meet one of these faces.
  FaceList faces_near(const FaceList& faces) const {
    constexpr std::int32_t margin = 2;  // a vertex of either face moves by at most a half-step
    std::vector<Box> boxes;
    for (const std::uint32_t face : faces) {
      const std::uint32_t* const numbers = mesh_.face(face);
      const Vertex corners[] = {mesh_.lattice[numbers[0]], mesh_.lattice[numbers[1]],
                                mesh_.lattice[numbers[2]]};
      const VertexBox box = box_around(std::begin(corners), std::end(corners));
      const Vertex by{margin, margin, margin};
      boxes.push_back(box_of(box.low - by, box.high + by));
    }
    const std::vector<std::uint8_t> are_near = polygons_near(boxes);
    FaceList found;
    for (std::uint32_t face = 0; face < mesh_.face_count(); ++face)
      if (are_near[mesh_.polygons[face]] != 0) found.push_back(face);
    return found;
  }

  // Numbers the crossings in a face and on its sides. Returns whether there was a new crossing.
  bool number_crossings(std::size_t face) {
    const std::size_t vertices = mesh_.lattice.size();
    const Incidence incidence = surface_.polygons[mesh_.polygons[face]].incidence;
    const std::uint32_t* corners = mesh_.face(face);
    const LatticePlane plane(mesh_.lattice[corners[0]], incidence);
    const bool is_mirrored = meshing::is_mirrored(surface_.spacing_mm);
    std::array<PlanePoint, 3> points;
    for (std::size_t i = 0; i < 3; ++i)
      points[i] = plane.at(mesh_.lattice[corners[is_mirrored ? 2 - i : i]]);
    for (const Vertex& crossing : Refinement::crossings_in(plane, points)) add_vertex(crossing);
    return mesh_.lattice.size() > vertices;
  }

  const Surface& surface_;
  MeshingOptions options_;
  VertexNumbers vertices_;
  std::vector<Point> moved_;  // new positions of numbered vertices; Units: half-steps
  FaceMesh mesh_;
  std::vector<bool> leaves_out_;  // one per face, as in MovedTriangles
};

}  // namespace

FaceMesh interpolated_mesh(const Surface& surface, VertexNumbers vertices,
                           const MeshingOptions& options) {
  return InterpolatedMesh(surface, std::move(vertices), options).build();
}

}  // namespace discmc::meshing
