#include "box_tree.hpp"

namespace discmc::meshing {
namespace {

// The lowest ten bits of a number, two bits apart.
std::uint32_t spread(std::uint32_t number) {
  number = (number | number << 16) & 0x030000FF;
  number = (number | number << 8) & 0x0300F00F;
  number = (number | number << 4) & 0x030C30C3;
  return (number | number << 2) & 0x09249249;
}

// The place of a box on a curve through space on which neighbours are mostly near: the bits of its
// three coordinates in turn (G. M. Morton, 1966).
std::uint32_t place_on_curve(const Box& box, const Box& all) {
  constexpr float most = (1U << 10) - 1;
  std::uint32_t place = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float size = all.high[axis] - all.low[axis];
    const float middle = box.low[axis] / 2 + box.high[axis] / 2;
    const float part = size > 0 ? std::clamp((middle - all.low[axis]) / size, 0.0F, 1.0F) : 0;
    place |= spread(static_cast<std::uint32_t>(part * most)) << axis;
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
  boxes_.resize(std::max<std::size_t>(1, (boxes.size() + leaf_size - 1) / leaf_size));
  while (leaves_ * leaf_size < boxes.size()) leaves_ *= 2;
  nodes_.resize(2 * leaves_);
  wanted_.assign(nodes_.size(), 0xFF);
  for (const std::uint64_t each : order) {
    const std::size_t slot = places_.size();
    const auto place = static_cast<std::uint32_t>(each);
    slots_[place] = static_cast<std::uint32_t>(slot);
    places_.push_back(place);
    boxes_[slot / leaf_size].set(slot % leaf_size, boxes[place]);
    nodes_[leaves_ + slot / leaf_size].include(boxes[place]);
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].include(nodes_[2 * node + 1]);
  }
}

void BoxTree::replace(std::uint32_t place, const Box& box) {
  const std::size_t slot = slots_[place];
  Leaf& leaf = boxes_[slot / leaf_size];
  leaf.set(slot % leaf_size, box);
  std::size_t node = leaves_ + slot / leaf_size;
  Box all;
  for (std::size_t i = 0; i < leaf_size; ++i) all.include(leaf.box(i));
  for (; !(nodes_[node] == all); node /= 2) {
    nodes_[node] = all;
    if (node == 1) return;
    all.include(nodes_[node ^ 1]);
  }
}

}  // namespace discmc::meshing
