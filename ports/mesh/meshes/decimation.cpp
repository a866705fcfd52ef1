#include "decimation.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mesh_edges.hpp"
#include "mesh_simplifier.hpp"
#include "slivers.hpp"

namespace discmc::meshing {
namespace {

using CornerNumbers = std::vector<std::uint32_t>;

constexpr std::uint32_t of_tetrahedron = 4;  // the least faces that enclose anything

class Decimator {
 public:
  explicit Decimator(const FaceMesh& mesh)
      : mesh_(mesh), is_kept_(mesh.face_count()), is_open_(mesh.vertices_mm.size()) {
    const std::vector<FaceEdge> edges = sorted_edges(mesh);
    for_each_edge(edges, [this](const FaceEdge* uses, std::size_t count) {
      if (is_closed_edge(uses, count)) return;
      is_open_[uses->low] = is_open_[uses->high] = true;
    });
    number_bodies(connected_faces(edges, mesh.face_count()));
  }

  // If too much would have to be kept, fewer triangles are removed everywhere; at last none.
  CornerNumbers decimated(Decimation decimation) {
    const std::uint64_t all = is_kept_.size();
    for (unsigned attempts = 0; attempts < max_attempts; ++attempts) {
      if (std::optional<CornerNumbers> corners = attempt(decimation)) return *std::move(corners);
      const std::uint64_t removed = all - std::min(all, decimation.triangles);
      decimation.triangles += std::min(decimation.triangles, removed) / 2;
      decimation.max_error_mm /= 2;
      is_kept_.assign(is_kept_.size(), false);
    }
    is_kept_.assign(is_kept_.size(), true);
    error_ = 0;
    return mesh_.corners;
  }

  // Of the mesh that decimated() returned: how many faces were kept, which are the first, and the
  // error of the others.
  std::size_t kept() const {
    return static_cast<std::size_t>(std::count(is_kept_.begin(), is_kept_.end(), true));
  }
  double error() const { return error_; }

  DecimatedBodies bodies() const {
    std::vector<bool> changes(bodies_);
    for (std::size_t face = 0; face < is_kept_.size(); ++face)
      if (!is_kept_[face]) changes[body_of_face_[face]] = true;
    return {bodies_, static_cast<std::size_t>(std::count(changes.begin(), changes.end(), false))};
  }

 private:
  static constexpr unsigned max_attempts = 20, max_rounds = 12;
  // At most one face in so many is kept: of whole bodies, and around wrong vertices.
  static constexpr std::size_t in_bodies = 2, around_wrong = 8;
  static constexpr std::uint32_t several = ~0U;  // bodies

  static bool is_closed_edge(const FaceEdge* uses, std::size_t count) {
    return count == 2 && uses[0].falls != uses[1].falls;
  }

  void number_bodies(Sets faces) {
    std::vector<std::uint32_t> number(mesh_.face_count());
    body_of_vertex_.assign(mesh_.vertices_mm.size(), several);
    std::vector<bool> is_seen(mesh_.vertices_mm.size());
    for (std::uint32_t face = 0; face < mesh_.face_count(); ++face) {
      const std::uint32_t name = faces.name(face);
      if (name == face) number[face] = bodies_++;
      const std::uint32_t body = number[name];
      body_of_face_.push_back(body);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh_.face(face)[i];
        if (!is_seen[vertex])
          body_of_vertex_[vertex] = body;
        else if (body_of_vertex_[vertex] != body)
          body_of_vertex_[vertex] = several;
        is_seen[vertex] = true;
      }
    }
  }

  // Nothing if too much has to be kept.
  std::optional<CornerNumbers> attempt(const Decimation& decimation) {
    std::size_t in_bodies_kept = 0, around_wrong_kept = 0;
    for (unsigned round = 1;; ++round) {
      CornerNumbers corners = decimated_once(decimation);
      find_wrong(corners);
      if (wrong_.empty() && lost_.empty()) return corners;
      for (const std::uint32_t vertex : wrong_)
        if (round > max_rounds && body_of_vertex_[vertex] < bodies_)
          lost_.push_back(body_of_vertex_[vertex]);
      const std::size_t in_bodies_new = keep_bodies();
      const std::size_t around_wrong_new = in_bodies_new > 0 ? 0 : keep_around_wrong(1 + round);
      if (in_bodies_new + around_wrong_new == 0) return corners;
      in_bodies_kept += in_bodies_new;
      around_wrong_kept += around_wrong_new;
      const std::size_t faces = is_kept_.size();
      if (in_bodies_kept > faces / in_bodies || around_wrong_kept > faces / around_wrong)
        return std::nullopt;
    }
  }

  // The faces that are kept, then what the library makes of the others.
  CornerNumbers decimated_once(const Decimation& decimation) {
    CornerNumbers result, others;
    for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
      CornerNumbers& corners = is_kept_[face] ? result : others;
      corners.insert(corners.end(), mesh_.face(face), mesh_.face(face) + 3);
    }
    // The others make up for those, but not so that hardly any of them are left.
    const std::uint64_t kept = result.size() / 3;
    const std::uint64_t share = decimation.triangles * (others.size() / 3) / is_kept_.size();
    const std::uint64_t wanted = std::min<std::uint64_t>(
        std::max(decimation.triangles, kept + share - share / 10) - kept, others.size() / 3);
    const double error = decimation.max_error_mm > 0 ? decimation.max_error_mm
                                                     : std::numeric_limits<double>::infinity();
    const Simplified fewer =
        simplified(mesh_.vertices_mm, others, static_cast<std::size_t>(wanted), error);
    error_ = fewer.error;
    result.insert(result.end(), fewer.corners.begin(), fewer.corners.end());
    return result;
  }

  // Finds vertices of edges that are not used once in each direction, unless that was so before;
  // of faces without area; of pieces that enclose nothing; and bodies without any other piece.
  void find_wrong(const CornerNumbers& corners) {
    wrong_.clear();
    const FaceMesh triangles = mesh_of(corners);
    const std::vector<FaceEdge> edges = sorted_edges(triangles);
    for_each_edge(edges, [this](const FaceEdge* uses, std::size_t count) {
      const bool was_open = is_open_[uses->low] && is_open_[uses->high];
      if (is_closed_edge(uses, count) || (count == 1 && was_open)) return;
      wrong_.insert(wrong_.end(), {uses->low, uses->high});
    });

    Sets pieces = connected_faces(edges, triangles.face_count());
    std::vector<std::uint32_t> sizes(triangles.face_count());
    for (std::uint32_t face = 0; face < sizes.size(); ++face) ++sizes[pieces.name(face)];
    std::vector<bool> is_found(bodies_);
    for (std::uint32_t face = 0; face < sizes.size(); ++face) {
      const std::uint32_t* const vertices = triangles.face(face);
      if (is_degenerate(triangles, face)) wrong_.insert(wrong_.end(), vertices, vertices + 3);
      if (sizes[pieces.name(face)] < of_tetrahedron && !is_open_[vertices[0]])
        wrong_.insert(wrong_.end(), vertices, vertices + 3);
      else
        for (std::size_t i = 0; i < 3; ++i)
          if (body_of_vertex_[vertices[i]] < bodies_) is_found[body_of_vertex_[vertices[i]]] = true;
    }
    lost_.clear();
    for (std::uint32_t body = 0; body < bodies_; ++body)
      if (!is_found[body]) lost_.push_back(body);
  }

  // Both return how many faces there were that had not been kept before.
  std::size_t keep_bodies() {
    std::vector<bool> is_lost(bodies_);
    for (const std::uint32_t body : lost_) is_lost[body] = true;
    std::size_t count = 0;
    for (std::size_t face = 0; face < is_kept_.size(); ++face) {
      if (is_kept_[face] || !is_lost[body_of_face_[face]]) continue;
      is_kept_[face] = true;
      ++count;
    }
    return count;
  }

  std::size_t keep_around_wrong(unsigned rings) {
    std::vector<bool> is_near(mesh_.vertices_mm.size());
    for (const std::uint32_t vertex : wrong_) is_near[vertex] = true;
    std::size_t count = 0;
    for (; rings > 0; --rings) {
      const std::vector<bool> was_near = is_near;
      for (std::size_t face = 0; face < is_kept_.size(); ++face) {
        const std::uint32_t* const vertices = mesh_.face(face);
        if (!was_near[vertices[0]] && !was_near[vertices[1]] && !was_near[vertices[2]]) continue;
        for (std::size_t i = 0; i < 3; ++i) is_near[vertices[i]] = true;
        count += is_kept_[face] ? 0U : 1U;
        is_kept_[face] = true;
      }
    }
    return count;
  }

  FaceMesh mesh_of(const CornerNumbers& corners) const {
    FaceMesh mesh;
    mesh.vertices_mm = mesh_.vertices_mm;
    mesh.corners = corners;
    for (std::size_t end = 3; end <= corners.size(); end += 3) mesh.face_begin.push_back(end);
    return mesh;
  }

  const FaceMesh& mesh_;
  std::vector<bool> is_kept_;  // faces
  std::vector<bool> is_open_;  // vertices, of edges that are not closed
  std::uint32_t bodies_ = 0;
  std::vector<std::uint32_t> body_of_face_, body_of_vertex_;
  std::vector<std::uint32_t> wrong_;  // vertices, of what was decimated last
  std::vector<std::uint32_t> lost_;   // bodies
  double error_ = 0;                  // of what was decimated last, as quadrics estimate it
};

// Those that a face has, in their order.
void drop_other_vertices(FaceMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.vertices_mm.size());
  for (const std::uint32_t corner : mesh.corners) number[corner] = 1;
  std::uint32_t left = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == 0) continue;
    mesh.vertices_mm[left] = mesh.vertices_mm[i];
    mesh.lattice[left] = mesh.lattice[i];
    number[i] = left++;
  }
  mesh.vertices_mm.resize(left);
  mesh.lattice.resize(left);
  for (std::uint32_t& corner : mesh.corners) corner = number[corner];
}

}  // namespace

DecimatedBodies decimate(FaceMesh& mesh, const Decimation& decimation) {
  if (mesh.face_count() == 0) return {};
  Decimator decimator(mesh);
  mesh.corners = decimator.decimated(decimation);
  mesh.face_begin.resize(mesh.corners.size() / 3 + 1);
  mesh.incidences.clear();
  mesh.polygons.clear();
  // Single places of a decimated mesh are that far away already.
  if (decimator.error() > 0) remove_slivers(mesh, decimator.kept(), 2 * decimator.error());
  drop_other_vertices(mesh);
  return decimator.bodies();
}

}  // namespace discmc::meshing
