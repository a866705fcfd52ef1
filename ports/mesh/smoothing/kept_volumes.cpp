#include "kept_volumes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "jobs/parallel.hpp"
#include "meshes/mesh.hpp"
#include "meshes/outline.hpp"
#include "surface/components.hpp"
#include "surface/polygon_crossings.hpp"
#include "surface/sets.hpp"

namespace discmc::meshing {
namespace {

using Id = Crossings::Id;
using Ends = Crossings::Ends;

constexpr std::uint32_t no_piece = ~0U, no_edge = ~0U;
constexpr double accuracy = 5e-4;  // share of the volume
constexpr unsigned max_rounds = 25;

// A body or a cavity: one component of a surface.
struct Piece {
  struct Edge {
    Id crossing_id;
    float sign;               // 1 if its edge begins on, -1 if it ends on
    std::uint32_t neighbour;  // the piece on the other side of the edge, or no_piece
    Ends ends;
  };
  // A vertex of the surface's mesh.
  struct Corner {
    Vertex lattice;
    bool is_crossing;  // whether it can move
    Edge edge;         // of the crossing; a copy for sequential access
  };

  std::size_t surface;
  double volume_mm3;    // of its voxels; negative for a cavity
  double target_mm3;    // the volume to enclose
  double shift_mm = 0;  // outwards
  std::vector<Edge> edges{};
  std::vector<Edge> centroid_crossings{};  // crossings around its centroids
  std::vector<Corner> corners{};
  std::vector<Triangle> faces{};
};

// The wall between a piece and a neighbour, through which they exchange volume. neighbour: no_piece
// if there is none.
struct Wall {
  std::uint32_t neighbour;
  double area_mm2;  // change of volume per difference of shifts
};

// Returns the voxel of an edge that is off. middle: of the edge.
Vertex off_voxel(const Vertex& middle, Id id, bool falls) {
  std::array<std::int32_t, 3> at = {middle.x, middle.y, middle.z};
  at[id.axis] += falls ? 1 : -1;
  return {at[0], at[1], at[2]};
}

class VolumeKeeper {
 public:
  VolumeKeeper(const std::vector<SmoothSurface>& surfaces, const VolumeKeeping& keeping)
      : surfaces_(surfaces), keeping_(keeping), pieces_by_surface_(surfaces.size()) {
    for_each_surface([this](std::size_t i) { find_pieces(i); });
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      pieces_by_surface_[i].first_piece = static_cast<std::uint32_t>(pieces_.size());
      for (const double volume : pieces_by_surface_[i].volumes_mm3)
        pieces_.push_back({i, volume, volume});
    }
    for_each_surface([this](std::size_t i) { find_edges(i); });
    for_each_piece_by_surface([this](std::size_t i) {
      for (Piece::Edge& edge : pieces_[i].edges)
        edge.ends = surfaces_[pieces_[i].surface].crossings->ends(edge.crossing_id);
      move_crossings(pieces_[i]);
    });
  }

  // Moved crossings change which ones the mesh leaves out, so it is rebuilt up to three times.
  void keep() {
    constexpr unsigned max_meshes = 3;
    for (unsigned meshes = 0; meshes < max_meshes; ++meshes) {
      for_each_surface([this](std::size_t i) { add_mesh(i); });
      const bool is_kept = balance();
      for_each_piece_by_surface([this](std::size_t i) { move_crossings(pieces_[i]); });
      if (is_kept) return;
    }
  }

 private:
  // The pieces of a surface's polygons and crossings, counted from its first one.
  struct SurfacePieces {
    std::uint32_t piece_of(Id id) const {
      return first_piece + piece_by_crossing[id.axis][id.number];
    }

    std::vector<double> volumes_mm3;                              // of the voxels of each piece
    std::uint32_t first_piece = 0;                                // index in pieces_
    std::vector<std::uint32_t> piece_by_polygon;                  // index from the first piece
    std::array<std::vector<std::uint32_t>, 3> piece_by_crossing;  // likewise, by axis
  };

  // Calls call(number) for each surface, in parallel.
  template <class Call>
  void for_each_surface(Call call) const {
    for_each_in_parallel(keeping_.jobs, surfaces_.size(), call);
  }
  // Calls call(number) for each piece. Pieces of a surface share its crossings, so one thread
  // visits them all.
  template <class Call>
  void for_each_piece_by_surface(Call call) const {
    for_each_surface([&](std::size_t number) {
      const SurfacePieces& surface_pieces = pieces_by_surface_[number];
      for (std::size_t i = 0; i < surface_pieces.volumes_mm3.size(); ++i)
        call(surface_pieces.first_piece + i);
    });
  }

  template <class Call>
  void for_each_crossing_of(std::size_t number, std::uint32_t polygon, Call call) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for_each_crossing(surfaces_[number].surface->polygons[polygon], axis,
                        [&](const Vertex& middle) {
                          if (const auto id = surfaces_[number].crossings->find(middle))
                            call(*id, middle);
                        });
  }

  void find_pieces(std::size_t number) {
    const Surface& surface = *surfaces_[number].surface;
    SurfacePieces& surface_pieces = pieces_by_surface_[number];
    surface_pieces.piece_by_polygon.resize(surface.polygons.size());
    for (std::size_t axis = 0; axis < 3; ++axis)
      surface_pieces.piece_by_crossing[axis].resize(surfaces_[number].crossings->count(axis));
    const Point& spacing = surface.spacing_mm;
    for (const Component& component : components(surface)) {
      const auto piece_index = static_cast<std::uint32_t>(surface_pieces.volumes_mm3.size());
      std::int64_t voxels = 0;
      for (const std::uint32_t polygon : component.polygons) {
        voxels += enclosed_voxels(surface.polygons[polygon]);
        surface_pieces.piece_by_polygon[polygon] = piece_index;
        for_each_crossing_of(number, polygon, [&](Id id, const Vertex&) {
          surface_pieces.piece_by_crossing[id.axis][id.number] = piece_index;
        });
      }
      surface_pieces.volumes_mm3.push_back(static_cast<double>(voxels) *
                                           std::fabs(spacing[0] * spacing[1] * spacing[2]));
    }
  }

  // The first of two surfaces with an edge sets the ends of both, so they are not read here.
  void find_edges(std::size_t number) {
    Crossings& crossings = *surfaces_[number].crossings;
    const SurfacePieces& surface_pieces = pieces_by_surface_[number];
    for (std::uint32_t polygon = 0; polygon < surface_pieces.piece_by_polygon.size(); ++polygon)
      for_each_crossing_of(number, polygon, [&](Id id, const Vertex& middle) {
        std::uint32_t neighbour = no_piece;
        const std::size_t other = surface_beyond(number, middle, id);
        if (other != VolumeKeeping::none) {
          const auto other_id = surfaces_[other].crossings->find(middle);
          neighbour = pieces_by_surface_[other].piece_of(*other_id);
          if (number < other)
            share_difference(crossings.ends(id), surfaces_[other].crossings->ends(*other_id));
        }
        pieces_[surface_pieces.first_piece + surface_pieces.piece_by_polygon[polygon]]
            .edges.push_back({id, crossings.falls(id) ? 1.0F : -1.0F, neighbour, {}});
      });
  }

  std::size_t surface_beyond(std::size_t number, const Vertex& middle, Id id) const {
    if (!keeping_.surface_of) return VolumeKeeping::none;
    return keeping_.surface_of(off_voxel(middle, id, surfaces_[number].crossings->falls(id)));
  }

  // Both sides of an edge get the difference of their ends, with opposite signs.
  static void share_difference(Ends& own, Ends& other) {
    own = {own.begin - other.begin, own.end - other.end};
    other = {-own.begin, -own.end};
  }

  void move_crossings(const Piece& piece) {
    Crossings& crossings = *surfaces_[piece.surface].crossings;
    for (const Piece::Edge& edge : piece.edges)
      crossings.move(edge.crossing_id, position_of(piece, edge));
  }

  // Returns a crossing, like Crossings::at(), with the current shifts.
  float position_of(const Piece& piece, const Piece::Edge& edge) const {
    const auto min_distance = static_cast<float>(keeping_.min_distance_mm);
    const double neighbour_shift =
        edge.neighbour == no_piece ? 0 : pieces_[edge.neighbour].shift_mm;
    const auto shift = static_cast<float>(piece.shift_mm - neighbour_shift);
    // Avoids branches on the direction of an edge, which are mispredicted.
    return Crossings::zero_between({std::max(edge.sign * (edge.ends.begin + shift), min_distance),
                                    std::min(edge.sign * (edge.ends.end + shift), -min_distance)});
  }

  void add_mesh(std::size_t number) {
    MeshingOptions options{true, Faces::triangles, surfaces_[number].crossings, keeping_.tolerance};
    options.separates = false;
    if (surfaces_.size() == 1) options.jobs = keeping_.jobs;
    const FaceMesh mesh = build_mesh(*surfaces_[number].surface, options);
    const SurfacePieces& surface_pieces = pieces_by_surface_[number];
    const auto pieces = pieces_.begin() + surface_pieces.first_piece;
    const auto pieces_end = pieces + static_cast<std::ptrdiff_t>(surface_pieces.volumes_mm3.size());
    std::for_each(pieces, pieces_end, [](Piece& piece) {
      piece.faces.clear();
      piece.corners.clear();
    });
    struct LocalCorner {
      std::uint32_t piece = no_piece, corner = 0;
    };
    std::vector<LocalCorner> local_corners(mesh.lattice.size());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      const std::uint32_t piece_index = surface_pieces.piece_by_polygon[mesh.polygons[face]];
      Piece& piece = pieces[piece_index];
      Triangle triangle;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.face(face)[i];
        if (local_corners[vertex].piece != piece_index) {
          local_corners[vertex] = {piece_index, static_cast<std::uint32_t>(piece.corners.size())};
          piece.corners.push_back({mesh.lattice[vertex], false, {}});
        }
        triangle[i] = local_corners[vertex].corner;
      }
      piece.faces.push_back(triangle);
    }
    std::array<std::vector<std::uint32_t>, 3> edges;  // index in piece.edges, by crossing
    for (std::size_t axis = 0; axis < 3; ++axis)
      edges[axis].resize(surfaces_[number].crossings->count(axis), no_edge);
    std::for_each(pieces, pieces_end, [&](Piece& piece) { find_edges_of_corners(piece, edges); });
  }

  // edges: scratch space without edges, before and after the call.
  void find_edges_of_corners(Piece& piece, std::array<std::vector<std::uint32_t>, 3>& edges) const {
    const auto edge_at = [&](Id id) -> auto& {
      return edges[id.axis][id.number];
    };
    for (std::uint32_t i = 0; i < piece.edges.size(); ++i) edge_at(piece.edges[i].crossing_id) = i;
    piece.centroid_crossings.clear();
    for (Piece::Corner& corner : piece.corners)
      surfaces_[piece.surface].crossings->for_each_near(corner.lattice, [&](Id id) {
        if (edge_at(id) == no_edge) return;
        const Piece::Edge& edge = piece.edges[edge_at(id)];
        corner.is_crossing = is_middle(corner.lattice);
        if (corner.is_crossing)
          corner.edge = edge;
        else
          piece.centroid_crossings.push_back(edge);
      });
    for (const Piece::Edge& edge : piece.edges) edge_at(edge.crossing_id) = no_edge;
  }

  // Returns the volume of the piece at its current shift.
  double enclosed_mm3(const Piece& piece) const {
    Crossings& crossings = *surfaces_[piece.surface].crossings;
    const Point& spacing = surfaces_[piece.surface].surface->spacing_mm;
    for (const Piece::Edge& edge : piece.centroid_crossings)
      crossings.move(edge.crossing_id, position_of(piece, edge));
    std::vector<Point> from_apex;
    from_apex.reserve(piece.corners.size());
    for (const auto& [lattice, is_crossing, edge] : piece.corners)
      from_apex.push_back(in_mm(
          is_crossing
              ? Crossings::interpolated(lattice, edge.crossing_id.axis, position_of(piece, edge))
              : crossings.interpolated(lattice),
          spacing));
    const Point apex = from_apex[0];  // near, to keep rounding small
    for (Point& corner : from_apex) corner = difference(corner, apex);
    double six_volumes = 0;
    for (const auto& [a, b, c] : piece.faces)
      six_volumes += dot(from_apex[a], cross(from_apex[b], from_apex[c]));
    return six_volumes / 6;
  }

  // Returns whether all volumes were already kept.
  bool balance() {
    const std::vector<double> before = shifts();
    if (surfaces_.size() == 1)
      set_shifts(target_shifts());
    else if (!move_by_newton() && !(share_shortage() && move_by_newton()))
      move_alternately();
    return shifts() == before;
  }

  std::vector<double> shifts() const {
    std::vector<double> shifts;
    for (const Piece& piece : pieces_) shifts.push_back(piece.shift_mm);
    return shifts;
  }
  void set_shifts(const std::vector<double>& shifts) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) pieces_[i].shift_mm = shifts[i];
  }

  // Returns the excess of each piece over its target.
  std::vector<double> excess_mm3() {
    if (keeping_.check) keeping_.check();
    std::vector<double> excess(pieces_.size());
    for_each_piece_by_surface([&](std::size_t i) {
      if (!pieces_[i].faces.empty()) excess[i] = enclosed_mm3(pieces_[i]) - pieces_[i].target_mm3;
    });
    return excess;
  }

  // Moves all pieces at once by Newton's method, while this brings them nearer. Returns whether all
  // pieces reach their targets.
  bool move_by_newton() {
    constexpr unsigned max_steps = 12;
    double before = std::numeric_limits<double>::infinity();
    std::vector<double> last = shifts();
    for (unsigned step = 0; step < max_steps; ++step) {
      const std::vector<double> excess = excess_mm3();
      bool is_kept = true;
      double sum = 0;  // of squares relative to the volume
      for (std::size_t i = 0; i < pieces_.size(); ++i) {
        is_kept &= is_near(pieces_[i], excess[i]);
        sum += excess[i] * excess[i] / (pieces_[i].volume_mm3 * pieces_[i].volume_mm3);
      }
      if (is_kept) return true;
      if (!(sum < before)) {
        set_shifts(last);
        return false;
      }
      before = sum;
      last = shifts();
      const std::vector<double> moves = moves_against(excess);
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        pieces_[i].shift_mm =
            std::clamp(last[i] + moves[i], -keeping_.max_shift_mm, keeping_.max_shift_mm);
    }
    return false;
  }

  static bool is_near(const Piece& piece, double excess_mm3) {
    return std::fabs(excess_mm3) <= accuracy * std::fabs(piece.volume_mm3);
  }

  // Touching pieces cannot all grow, because one gains what another loses. If their volumes do not
  // fit, for example because labels fill the volume to its corners, each gets an equal share of its
  // own. Returns whether any target was reduced.
  bool share_shortage() {
    Sets touching(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
      for (const Piece::Edge& edge : pieces_[i].edges)
        if (edge.neighbour != no_piece) touching.join(i, edge.neighbour);
    const std::vector<double> before = shifts();
    set_shifts(std::vector<double>(pieces_.size(), keeping_.max_shift_mm / 2));
    const std::vector<double> excess = excess_mm3();
    struct Group {
      double target_mm3 = 0, max_mm3 = 0, bodies_mm3 = 0;
      // A cavity and the piece that fills it need nothing together.
      bool is_short() const {
        return target_mm3 > accuracy * bodies_mm3 && max_mm3 < (1 - accuracy) * target_mm3;
      }
    };
    std::vector<Group> groups(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      Group& group = groups[touching.root(i)];
      group.target_mm3 += pieces_[i].target_mm3;
      group.max_mm3 += pieces_[i].target_mm3 + excess[i];
      group.bodies_mm3 += std::max(pieces_[i].target_mm3, 0.0);
    }
    bool is_any_short = false;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Group& group = groups[touching.root(i)];
      if (group.is_short())
        pieces_[i].target_mm3 *= group.max_mm3 / group.target_mm3;
      else
        pieces_[i].shift_mm = before[i];
      is_any_short |= group.is_short();
    }
    return is_any_short;
  }

  std::vector<double> target_shifts() {
    std::vector<double> targets;
    for (Piece& piece : pieces_) targets.push_back(shift_to_keep(piece));
    return targets;
  }

  // One piece gains what its neighbour loses, so each moves half of the way at a time.
  void move_alternately() {
    for (unsigned round = 0; round < max_rounds; ++round) {
      const std::vector<double> before = shifts(), targets = target_shifts();
      if (targets == before) return;
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        pieces_[i].shift_mm = (before[i] + targets[i]) / 2;
    }
  }

  // One piece gains what its neighbours lose. These are linear equations, solved by the
  // Gauss-Seidel method, which also ends if they have no solution.
  std::vector<double> moves_against(const std::vector<double>& excess) const {
    constexpr unsigned sweeps = 200;
    std::vector<std::vector<Wall>> walls;
    std::vector<std::uint32_t> wall_of_piece(pieces_.size(), no_piece);
    for (const Piece& piece : pieces_) walls.push_back(walls_of(piece, wall_of_piece));
    std::vector<double> moves(pieces_.size());
    for (unsigned sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t i = 0; i < pieces_.size(); ++i) {
        double area = 0, sum = -excess[i];
        for (const Wall& wall : walls[i]) {
          area += wall.area_mm2;
          if (wall.neighbour != no_piece) sum += wall.area_mm2 * moves[wall.neighbour];
        }
        if (area > 0) moves[i] = sum / area;
      }
    return moves;
  }

  // wall_of_piece: scratch space; no_piece for each piece, before and after the call.
  std::vector<Wall> walls_of(const Piece& piece, std::vector<std::uint32_t>& wall_of_piece) const {
    std::vector<Wall> walls = {{no_piece, 0}};
    for (const Piece::Edge& edge : piece.edges) {
      if (edge.neighbour == no_piece) {
        walls[0].area_mm2 += area_mm2(piece, edge);
        continue;
      }
      std::uint32_t& wall = wall_of_piece[edge.neighbour];
      if (wall == no_piece) {
        wall = static_cast<std::uint32_t>(walls.size());
        walls.push_back({edge.neighbour, 0});
      }
      walls[wall].area_mm2 += area_mm2(piece, edge);
    }
    for (std::size_t i = 1; i < walls.size(); ++i) wall_of_piece[walls[i].neighbour] = no_piece;
    return walls;
  }

  // Returns the wall's area that an edge represents: a voxel's face times the cosine between the
  // edge and the normal. The slope of the distance is that cosine. Between neighbours it is twice
  // as steep, and moves half as far.
  double area_mm2(const Piece& piece, const Piece::Edge& edge) const {
    const bool has_neighbour = edge.neighbour != no_piece;
    const auto shift =
        static_cast<float>(piece.shift_mm - (has_neighbour ? pieces_[edge.neighbour].shift_mm : 0));
    const Ends ends = edge.ends;
    const auto min_distance = static_cast<float>(keeping_.min_distance_mm);
    const float at_on = edge.sign > 0 ? ends.begin : ends.end;
    const float at_off = edge.sign > 0 ? ends.end : ends.begin;
    if (at_on + shift < min_distance || at_off + shift > -min_distance) return 0;
    const Point& spacing = surfaces_[piece.surface].surface->spacing_mm;
    const double along = spacing[edge.crossing_id.axis];
    return std::fabs(spacing[0] * spacing[1] * spacing[2]) / (along * along) *
           std::fabs(static_cast<double>(ends.begin - ends.end)) / (has_neighbour ? 4 : 1);
  }

  // Uses secants, halved if they lead too far. Returns the current shift if it is good enough.
  double shift_to_keep(Piece& piece) {
    if (keeping_.check) keeping_.check();
    const double start = piece.shift_mm;
    if (piece.faces.empty()) return start;
    const double closest = keeping_.min_distance_mm / 1000;
    double low = -keeping_.max_shift_mm, high = keeping_.max_shift_mm, slope = 0;
    double excess = enclosed_mm3(piece) - piece.target_mm3;
    while (!is_near(piece, excess) && high - low > closest) {
      (excess < 0 ? low : high) = piece.shift_mm;
      double next = slope > 0 ? piece.shift_mm - excess / slope : (low + high) / 2;
      if (!(next > low && next < high)) next = (low + high) / 2;
      const double before = excess, moved = next - piece.shift_mm;
      piece.shift_mm = next;
      excess = enclosed_mm3(piece) - piece.target_mm3;
      slope = (excess - before) / moved;
    }
    return std::exchange(piece.shift_mm, start);
  }

  const std::vector<SmoothSurface>& surfaces_;
  const VolumeKeeping& keeping_;
  std::vector<Piece> pieces_;
  std::vector<SurfacePieces> pieces_by_surface_;
};

}  // namespace

void keep_volumes(const std::vector<SmoothSurface>& surfaces, const VolumeKeeping& keeping) {
  VolumeKeeper keeper(surfaces, keeping);
  if (keeping.is_closed) keeper.keep();
}

}  // namespace discmc::meshing
