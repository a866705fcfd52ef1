#include "box_tree.hpp"

namespace discmc::meshing {
namespace {

// The place of a box on a curve through space on which neighbours are mostly near: the bits of its
// three coordinates in turn (G. M. Morton, 1966).
std::uint32_t place_on_curve(const Box& box, const Box& all) {
  constexpr unsigned bits = 10;
  constexpr float most = (1U << bits) - 1;
  std::uint32_t place = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float size = all.high[axis] - all.low[axis];
    const float middle = box.low[axis] / 2 + box.high[axis] / 2;
    const float part = size > 0 ? std::clamp((middle - all.low[axis]) / size, 0.0F, 1.0F) : 0;
    const auto cell = static_cast<std::uint32_t>(part * most);
    for (unsigned bit = 0; bit < bits; ++bit)
      place |= (cell >> bit & 1) << (std::size_t{3} * bit + axis);
  }
  return place;
}

}  // namespace

double Box::squared_distance(const Point& point) const {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double below = static_cast<double>(low[axis]) - point[axis];
    const double above = point[axis] - static_cast<double>(high[axis]);
    const double away = std::max({below, above, 0.0});
    sum += away * away;
  }
  return sum;
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.include(box);
  std::vector<std::uint64_t> order;  // place on the curve, place in what was given
  order.reserve(boxes.size());
  for (const Box& box : boxes)
    order.push_back(std::uint64_t{place_on_curve(box, all)} << 32 | order.size());
  std::sort(order.begin(), order.end());
  slots_.resize(boxes.size());
  places_.reserve(boxes.size());
  boxes_.reserve(boxes.size());
  for (const std::uint64_t each : order) {
    slots_[static_cast<std::uint32_t>(each)] = static_cast<std::uint32_t>(places_.size());
    places_.push_back(static_cast<std::uint32_t>(each));
    boxes_.push_back(boxes[places_.back()]);
  }

  while (leaves_ * leaf_size < boxes_.size()) leaves_ *= 2;
  nodes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    nodes_[leaves_ + i / leaf_size].include(boxes_[i]);
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].include(nodes_[2 * node + 1]);
  }
}

void BoxTree::replace(std::uint32_t place, const Box& box) {
  const std::size_t slot = slots_[place];
  boxes_[slot] = box;
  std::size_t node = leaves_ + slot / leaf_size;
  Box all;
  for (std::size_t i = begin_of(node); i < end_of(node); ++i) all.include(boxes_[i]);
  for (; !(nodes_[node] == all); node /= 2) {
    nodes_[node] = all;
    if (node == 1) return;
    all.include(nodes_[node ^ 1]);
  }
}

}  // namespace discmc::meshing
