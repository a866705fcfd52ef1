// Numbers of lattice vertices: one per vertex, in any order, for all corners together or one by
// one.
#include "meshes/vertex_numbers.hpp"

#include <random>

#include "hand_made.hpp"
#include "test.hpp"

namespace {

using discmc::Vertex;
using discmc::meshing::VertexNumbers;

// Vertices with an odd sum, in adjacent blocks, many of them repeated. far: the minimum coordinate
// z of some of them.
std::vector<Vertex> some_vertices(std::uint32_t seed, std::int32_t far) {
  std::minstd_rand random(seed);
  std::vector<Vertex> vertices;
  for (std::int32_t i = 0; i < 20000; ++i) {
    const auto below = [&random](std::uint32_t end) {
      return static_cast<std::int32_t>(random() % end);
    };
    Vertex vertex = {below(30) - 1, below(30) - 9, i / 100 + below(40) - 1};
    if (below(8) == 0) vertex.z = far + below(8);
    if ((vertex.x + vertex.y + vertex.z) % 2 == 0) ++vertex.x;
    vertices.push_back(vertex);
  }
  return vertices;
}

bool is_below(const Vertex& a, const Vertex& b) {
  return discmc::precedes(a, b);
}

// Whether the vertices have different numbers, and no other vertex has one.
void check_numbers(const VertexNumbers& numbers, std::vector<Vertex> vertices) {
  std::sort(vertices.begin(), vertices.end(), is_below);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Vertex> numbered = numbers.positions();
  bool are_found = true;
  for (std::uint32_t i = 0; i < numbered.size(); ++i) {
    const Vertex &at = numbered[i], beside = {at.x + 2, at.y, at.z};
    are_found = are_found && numbers.find(at) == i;
    if (!std::binary_search(vertices.begin(), vertices.end(), beside, is_below))
      are_found = are_found && numbers.find(beside) == VertexNumbers::none;
  }
  CHECK(are_found);
  std::sort(numbered.begin(), numbered.end(), is_below);
  CHECK(numbered == vertices);
}

}  // namespace

TEST_CASE("vertex numbers follow the order in which vertices are first added") {
  VertexNumbers numbers;
  CHECK(numbers.find({1, 2, 4}) == VertexNumbers::none);
  CHECK(numbers.add({1, 2, 4}) == 0);
  CHECK(numbers.add({-1, 3, -1}) == 1);
  CHECK(numbers.add({1, 2, 2}) == 2);
  CHECK(numbers.add({1, 2, 4}) == 0);
  CHECK(numbers.find({-1, 3, -1}) == 1);
  CHECK(numbers.find({-1, 2, 4}) == VertexNumbers::none);
  CHECK(numbers.positions() == std::vector<Vertex>{{1, 2, 4}, {-1, 3, -1}, {1, 2, 2}});
}

TEST_CASE("polygon corners at one vertex share a number, which later additions do not change") {
  constexpr std::int32_t near = 20, far = 2000000000;  // a slot per block, and a hash table
  for (const std::int32_t z_of_some : {near, far}) {
    CAPTURE(z_of_some);
    std::vector<Vertex> vertices = some_vertices(1, z_of_some);
    VertexNumbers numbers(hand_made::polygon({0, 0, 1}, {vertices}));
    check_numbers(numbers, vertices);
    std::vector<Vertex> numbered = numbers.positions();
    const std::size_t before = numbered.size();
    for (const Vertex& vertex : some_vertices(2, far)) {
      const std::uint32_t number = numbers.add(vertex);
      if (number == numbered.size()) numbered.push_back(vertex);
      REQUIRE(numbered[number] == vertex);
      vertices.push_back(vertex);
    }
    check_numbers(numbers, vertices);
    CHECK(numbered.size() > before);
    CHECK(numbers.positions() == numbered);
  }
}

TEST_CASE("the numbers of corners do not depend on the number of jobs") {
  discmc::meshing::Polygons polygons;
  for (const Vertex& vertex : some_vertices(3, 20))
    polygons.append(hand_made::polygon({0, 0, 1}, {{vertex, vertex + Vertex{40, 0, 0}}}));
  CHECK(VertexNumbers(polygons, 3).positions(3) == VertexNumbers(polygons).positions());
}

TEST_CASE("vertices are numbered block by block, and in a block by z, y and x") {
  const VertexNumbers numbers(
      hand_made::polygon({0, 0, 1}, {{{9, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {15, 7, 7}}}));
  CHECK(numbers.positions() ==
        std::vector<Vertex>{{9, 0, 0}, {15, 7, 7}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}
