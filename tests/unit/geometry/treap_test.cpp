// A treap, compared with a sorted list; and its shape.
#include <discmc/geometry/treap.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using test::Chance;

namespace {

// Nodes 1, 1 + stride, ..., sorted by their keys. Access to no_slot fails.
class Nodes {
 public:
  explicit Nodes(std::vector<int32_t> keys, uint32_t stride = 1)
      : keys_(std::move(keys)), links_(keys_.size()), stride_(stride) {}

  uint32_t node(size_t index) const { return 1 + static_cast<uint32_t>(index) * stride_; }
  int32_t key(uint32_t node) const { return keys_.at((node - 1) / stride_); }
  uint32_t& left(uint32_t node) const { return links_.at((node - 1) / stride_).first; }
  uint32_t& right(uint32_t node) const { return links_.at((node - 1) / stride_).second; }
  bool precedes(uint32_t node, uint32_t other) const { return key(node) < key(other); }

 private:
  std::vector<int32_t> keys_;
  mutable std::vector<std::pair<uint32_t, uint32_t>> links_;
  uint32_t stride_;
};

using Tree = Treap<Nodes>;

// All nodes with their depths, parents before children, left before right.
std::vector<std::pair<uint32_t, uint32_t>> shape_of(const Tree& tree, const Nodes& nodes) {
  std::vector<std::pair<uint32_t, uint32_t>> shape, open{{tree.root(), 1}};
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    if (node == no_slot) continue;
    shape.emplace_back(node, depth);
    open.emplace_back(nodes.right(node), depth + 1);
    open.emplace_back(nodes.left(node), depth + 1);
  }
  return shape;
}

std::vector<int32_t> shuffled_keys(uint32_t count, Chance& chance) {
  std::vector<int32_t> keys(count);
  for (uint32_t i = 0; i < count; ++i) keys[i] = static_cast<int32_t>(10 * i);
  for (uint32_t i = count; i > 1; --i) std::swap(keys[i - 1], keys[chance.below(i)]);
  return keys;
}

}  // namespace

TEST_CASE("a treap finds the same nodes as a sorted list after any insertions and removals") {
  Chance chance(1);
  const Nodes nodes(shuffled_keys(60, chance));
  Tree tree;
  std::vector<uint32_t> inside;  // sorted
  for (int step = 0; step < 3000; ++step) {
    const uint32_t node = nodes.node(chance.below(60));
    const auto place =
        std::lower_bound(inside.begin(), inside.end(), node,
                         [&](uint32_t a, uint32_t b) { return nodes.precedes(a, b); });
    if (place != inside.end() && *place == node) {
      tree.remove(nodes, node);
      inside.erase(place);
    } else {
      tree.insert(nodes, node);
      inside.insert(place, node);
    }
    const auto bound = static_cast<int32_t>(chance.below(62)) * 10 - 5 * (step % 2);
    const auto first = std::find_if(inside.begin(), inside.end(),
                                    [&](uint32_t each) { return nodes.key(each) >= bound; });
    const uint32_t expected = first == inside.end() ? no_slot : *first;
    REQUIRE(tree.first(nodes, [&](uint32_t each) { return nodes.key(each) >= bound; }) == expected);
    const bool is_there = expected != no_slot && nodes.key(expected) == bound;
    REQUIRE(tree.find(nodes, [&](uint32_t each) { return (nodes.key(each) - bound) / 5; }) ==
            (is_there ? expected : no_slot));
  }
}

TEST_CASE("the shape of a treap depends only on its nodes, not on the order of calls") {
  Chance chance(2);
  constexpr uint32_t count = 300;
  const std::vector<int32_t> keys = shuffled_keys(count, chance);
  const Nodes nodes(keys), others(keys);
  Tree tree;
  std::vector<bool> is_inside(count);
  for (int round = 0; round < 40; ++round) {
    for (int step = 0; step < 200; ++step) {
      const uint32_t index = chance.below(count);
      if (is_inside[index])
        tree.remove(nodes, nodes.node(index));
      else
        tree.insert(nodes, nodes.node(index));
      is_inside[index] = !is_inside[index];
    }
    Tree other;
    for (uint32_t index = count; index-- > 0;)
      if (is_inside[index]) other.insert(others, others.node(index));
    REQUIRE(shape_of(tree, nodes) == shape_of(other, others));
  }
}

TEST_CASE("a treap of sorted keys is shallow for any stride of node numbers") {
  constexpr uint32_t count = 4000;
  std::vector<int32_t> keys(count);
  for (uint32_t i = 0; i < count; ++i) keys[i] = static_cast<int32_t>(i);
  for (const uint32_t stride : {1U, 2U, 3U, 5U, 6U, 64U, 255U, 256U, 4096U, 65536U, 1048573U}) {
    CAPTURE(stride);
    const Nodes nodes(keys, stride);
    Tree tree;
    for (uint32_t i = 0; i < count; ++i) tree.insert(nodes, nodes.node(i));
    uint32_t deepest = 0;
    for (const auto& [node, depth] : shape_of(tree, nodes)) deepest = std::max(deepest, depth);
    CHECK(deepest < 40);  // 12 at the least
  }
}
