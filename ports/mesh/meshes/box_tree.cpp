#include "box_tree.hpp"

namespace discmc::meshing {
namespace {

constexpr std::uint32_t bits_per_axis = 10;

// Spreads the bits of a number, with two zero bits between them.
std::uint32_t spread(std::uint32_t number) {
  number = (number | number << 16) & 0x030000FF;
  number = (number | number << 8) & 0x0300F00F;
  number = (number | number << 4) & 0x030C30C3;
  return (number | number << 2) & 0x09249249;
}

// Returns the position of a point along Hilbert's curve (J. Skilling, Programming the Hilbert
// Curve, 2004). The curve fills a cube in steps between neighbours, so a part of it has compact
// boxes.
std::uint32_t position_on_curve(std::array<std::uint32_t, 3> at) {
  for (std::uint32_t bit = 1U << (bits_per_axis - 1); bit > 1; bit /= 2)
    for (std::uint32_t& each : at) {
      const std::uint32_t below = bit - 1, is_set = (each & bit) != 0 ? ~0U : 0U;
      const std::uint32_t swapped = (at[0] ^ each) & below & ~is_set;
      each ^= swapped;
      at[0] ^= swapped | (below & is_set);
    }
  at[1] ^= at[0];
  at[2] ^= at[1];
  std::uint32_t flipped = 0;
  for (std::uint32_t bit = 1U << (bits_per_axis - 1); bit > 1; bit /= 2)
    if ((at[2] & bit) != 0) flipped ^= bit - 1;
  return spread(at[0] ^ flipped) << 2 | spread(at[1] ^ flipped) << 1 | spread(at[2] ^ flipped);
}

std::uint32_t position_on_curve(const Box& box, const Box& bounds) {
  constexpr float max_coordinate = (1U << bits_per_axis) - 1;
  std::array<std::uint32_t, 3> at;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float size = bounds.high[axis] - bounds.low[axis];
    const float middle = box.low[axis] / 2 + box.high[axis] / 2;
    const float part = size > 0 ? std::clamp((middle - bounds.low[axis]) / size, 0.0F, 1.0F) : 0;
    at[axis] = static_cast<std::uint32_t>(part * max_coordinate);
  }
  return position_on_curve(at);
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

std::vector<std::uint32_t> along_curve(const std::vector<Box>& boxes, unsigned jobs) {
  Box bounds;
  for (const Box& box : boxes) bounds.include(box);
  std::vector<std::uint64_t> order(boxes.size());  // position along the curve, index of the box
  for_each_range_in_parallel(jobs, boxes.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      order[i] = std::uint64_t{position_on_curve(boxes[i], bounds)} << 32 | i;
  });
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> indexes;
  indexes.reserve(order.size());
  for (const std::uint64_t each : order) indexes.push_back(static_cast<std::uint32_t>(each));
  return indexes;
}

BoxTree::BoxTree(const std::vector<Box>& boxes, unsigned jobs)
    : indexes_(along_curve(boxes, jobs)),
      slots_(boxes.size()),
      wanted_(std::max<std::size_t>(1, (boxes.size() + 3) / 4), 0xF) {
  for (std::size_t nodes = 1; nodes < wanted_.size(); nodes *= 4) leaves_ += nodes;
  boxes_.resize(leaves_ + wanted_.size());
  for_each_range_in_parallel(jobs, indexes_.size(), [&](std::size_t first, std::size_t end) {
    static_assert(parallel_range % 4 == 0, "no leaf is in two ranges");
    for (std::size_t slot = first; slot < end; ++slot) {
      slots_[indexes_[slot]] = static_cast<std::uint32_t>(slot);
      boxes_[leaves_ + slot / 4].set(slot % 4, boxes[indexes_[slot]]);
    }
  });
  for (std::size_t node = boxes_.size() - 1; node > 0; --node)
    boxes_[parent(node)].set((node - 1) % 4, boxes_[node].around(0xF));
}

void BoxTree::replace(std::uint32_t index, const Box& box) {
  std::size_t node = leaves_ + slots_[index] / 4;
  boxes_[node].set(slots_[index] % 4, box);
  for (; node > 0; node = parent(node)) {
    const Box around = boxes_[node].around(0xF);
    if (boxes_[parent(node)][(node - 1) % 4] == around) return;
    boxes_[parent(node)].set((node - 1) % 4, around);
  }
}

}  // namespace discmc::meshing
