#include "relaxed_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "meshes/intersections.hpp"
#include "meshes/mesh.hpp"

namespace discmc::meshing {
namespace {

using Id = Crossings::Id;

constexpr unsigned passes = 6;
// The deviation of a crossing from the line of its neighbours. Units: edges.
constexpr double deviation = 0.15;

Vertex step_along(std::size_t axis) {
  return {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
}
Vertex times(int factor, const Vertex& vertex) {
  return {factor * vertex.x, factor * vertex.y, factor * vertex.z};
}

// Returns the mean of a normal distribution between two limits. Units: edges.
double mean_within(double middle, double low, double high) {
  constexpr double root_of_two_pi = 2.506628274631;
  const auto density = [](double x) { return std::exp(-x * x / 2) / root_of_two_pi; };
  const auto above = [](double x) { return std::erfc(x / std::sqrt(2)) / 2; };
  const double from = (low - middle) / deviation, to = (high - middle) / deviation;
  // Subtracting the smaller tails rounds least.
  const double share = from + to > 0 ? above(from) - above(to) : above(-to) - above(-from);
  return middle + deviation * (density(from) - density(to)) / share;
}

class Relaxer {
 public:
  Relaxer(Crossings& crossings, Border border) : crossings_(crossings), border_(border) {
    nodes_.reserve(crossings.count(0) + crossings.count(1) + crossings.count(2));
    crossings.for_each([this](Id id, const Vertex& middle) { add_node(id, middle); });
  }

  void pass() {
    relaxed_.clear();
    for (const Node& node : nodes_) relaxed_.push_back(relaxed(node));
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      crossings_.move(nodes_[i].crossing_id, relaxed_[i]);
  }

 private:
  // The way in which the surface continues across a face beside an edge.
  enum class Way : std::uint8_t {
    none,
    at_begin,  // to the face's edge at the beginning of this edge
    at_end,
    beside,  // to the parallel edge
    begin_of_border,
    end_of_border,
  };
  struct Neighbour {
    Way way;
    std::uint32_t number;  // number of the crossing
  };
  // A crossing with two neighbours in each of two planes.
  struct Node {
    Id crossing_id;
    float low, high;  // limits of the crossing. Units: edges
    std::array<std::array<Neighbour, 2>, 2> beside;
  };
  // The intersection of a line with the edge: along the edge from its beginning, and across. Units:
  // edges.
  struct Spot {
    double along, across;
  };

  static std::uint8_t axis_of_plane(const Node& node, std::size_t plane) {
    return static_cast<std::uint8_t>((node.crossing_id.axis + 1 + plane) % 3);
  }

  void add_node(Id id, const Vertex& middle) {
    const float at = crossings_.at(id) / 2;
    const float half = 0.5F / static_cast<float>(crossings_.intervals(id));
    Node node{id, at - half, at + half, {}};
    for (std::size_t plane = 0; plane < 2; ++plane)
      for (std::size_t side = 0; side < 2; ++side)
        node.beside[plane][side] = neighbour(
            id, middle, times(side == 0 ? -1 : 1, step_along(axis_of_plane(node, plane))));
    nodes_.push_back(node);
  }

  // The surface separates the voxels that are on in an ambiguous face. It therefore goes around the
  // edge's voxel that is on, if possible.
  Neighbour neighbour(Id id, const Vertex& middle, const Vertex& step) const {
    const Vertex half = step_along(id.axis);
    const bool falls = crossings_.falls(id);
    const auto around_on = crossings_.find((falls ? middle - half : middle + half) + step);
    if (around_on) return {falls ? Way::at_begin : Way::at_end, around_on->number};
    const auto around_off = crossings_.find((falls ? middle + half : middle - half) + step);
    if (around_off) return {falls ? Way::at_end : Way::at_begin, around_off->number};
    const auto beside = crossings_.find(middle + times(2, step));
    if (beside) return {Way::beside, beside->number};
    if (border_ == Border::open) return {Way::none, 0};
    return {falls ? Way::begin_of_border : Way::end_of_border, 0};
  }

  Spot spot(const Node& node, std::size_t plane, std::size_t side) const {
    const Neighbour& neighbour = node.beside[plane][side];
    const auto at = [&](std::uint8_t axis) {
      return static_cast<double>(crossings_.at({axis, neighbour.number})) / 2;
    };
    if (neighbour.way == Way::beside) return {at(node.crossing_id.axis), 1};
    constexpr double middle = 0.5;
    if (neighbour.way == Way::begin_of_border) return {0, middle};
    if (neighbour.way == Way::end_of_border) return {1, middle};
    const double across = at(axis_of_plane(node, plane));
    return {neighbour.way == Way::at_begin ? 0.0 : 1.0, side == 0 ? 1 - across : across};
  }

  // Returns the mean position at which straight lines between neighbours cross the edge.
  float relaxed(const Node& node) const {
    double sum = 0;
    unsigned planes = 0;
    for (std::size_t plane = 0; plane < 2; ++plane) {
      const auto& beside = node.beside[plane];
      if (beside[0].way == Way::none || beside[1].way == Way::none) continue;
      const Spot before = spot(node, plane, 0), after = spot(node, plane, 1);
      sum += (before.along * after.across + after.along * before.across) /
             (before.across + after.across);
      ++planes;
    }
    if (planes == 0) return crossings_.at(node.crossing_id);
    const double mean =
        mean_within(sum / planes, static_cast<double>(node.low), static_cast<double>(node.high));
    return static_cast<float>(std::clamp(2 * mean, Crossings::margin, 2 - Crossings::margin));
  }

  Crossings& crossings_;
  Border border_;
  std::vector<Node> nodes_;
  std::vector<float> relaxed_;
};

// Moves a crossing half of the way to the middle, and in the last rounds all of it. Returns
// whether it had left the middle.
bool move_to_middle(Crossings& crossings, Id id, unsigned round) {
  constexpr unsigned halves = 3;
  const float at = crossings.at(id);
  crossings.move(id, round < halves ? (at + 1) / 2 : 1);
  return at != 1;
}

}  // namespace

// The loop ends, because faces of cells do not intersect if all crossings are in the middle.
void separate(Crossings& crossings, const Surface& surface, const Relaxation& relaxation) {
  bool is_moved = true;
  for (unsigned round = 0; is_moved; ++round) {
    const FaceMesh mesh = build_mesh(
        surface, {true, Faces::triangles, &crossings, relaxation.tolerance, 1, relaxation.check});
    is_moved = false;
    for (const auto& pair : intersecting_faces(mesh, all_faces(mesh), relaxation.check))
      for (const std::uint32_t face : pair)
        for (std::size_t i = 0; i < 3; ++i)
          crossings.for_each_near(mesh.lattice[mesh.face(face)[i]],
                                  [&](Id id) { is_moved |= move_to_middle(crossings, id, round); });
  }
}

void relax(Crossings& crossings, const Surface& surface, const Relaxation& relaxation) {
  Relaxer relaxer(crossings, relaxation.border);
  for (unsigned i = 0; i < passes; ++i) {
    if (relaxation.check) relaxation.check();
    relaxer.pass();
  }
  separate(crossings, surface, relaxation);
}

}  // namespace discmc::meshing
