// Numbers of lattice positions: the same one by one and by several jobs.
#include "meshes/vertex_numbers.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace {

using discmc::Vertex;
using discmc::meshing::VertexNumbers;

// By slices, more or less, and many of them several times; slices so far apart, too, that they
// share a table.
std::vector<Vertex> some_positions() {
  std::minstd_rand random(1);
  std::vector<Vertex> positions;
  for (int i = 0; i < 20000; ++i) {
    const auto below = [&random](std::uint32_t end) {
      return static_cast<std::int32_t>(random() % end);
    };
    positions.push_back({below(6), below(6), i / 100 + below(40) - 1 + 8192 * below(2)});
  }
  return positions;
}

}  // namespace

TEST_CASE("positions are numbered in the order in which they come first") {
  VertexNumbers numbers;
  CHECK(numbers.find({1, 2, 3}) == VertexNumbers::none);
  CHECK(numbers.add({1, 2, 3}) == 0);
  CHECK(numbers.add({-1, 2, -1}) == 1);
  CHECK(numbers.add({1, 2, 3}) == 0);
  CHECK(numbers.find({-1, 2, -1}) == 1);
  CHECK(numbers.find({-1, 2, 3}) == VertexNumbers::none);
  CHECK(numbers.positions() == std::vector<Vertex>{{1, 2, 3}, {-1, 2, -1}});
}

TEST_CASE("all at once get the same numbers by however many jobs") {
  const std::vector<Vertex> positions = some_positions();
  VertexNumbers one_by_one;
  std::vector<std::uint32_t> expected;
  for (const Vertex& position : positions) expected.push_back(one_by_one.add(position));
  for (const unsigned jobs : {1U, 2U, 3U, 20U}) {
    CAPTURE(jobs);
    VertexNumbers numbers;
    CHECK(numbers.add_all(positions, jobs) == expected);
    CHECK(numbers.positions() == one_by_one.positions());
    bool are_found = true;
    for (std::size_t i = 0; i < positions.size(); ++i)
      are_found = are_found && numbers.find(positions[i]) == expected[i];
    CHECK(are_found);
    const auto next = static_cast<std::uint32_t>(numbers.positions().size());
    CHECK(numbers.add({99, 99, 99}) == next);
  }
}
