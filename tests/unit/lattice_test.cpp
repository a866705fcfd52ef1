// Statements about the half-step lattice, its links and the directions of a plane; by exhaustion.
#include <discmc/lattice.hpp>

#include "incidences.hpp"
#include "test.hpp"

using namespace discmc;
using test::for_each_incidence;

namespace {

int squared_length(const Vertex& vector) {
  return dot_product(vector, vector);
}

int odd_coordinates(const Vertex& vector) {
  return (vector.x % 2 != 0) + (vector.y % 2 != 0) + (vector.z % 2 != 0);
}

}  // namespace

TEST_CASE("vertices add, subtract and multiply by component") {
  constexpr Vertex a{1, -2, 3};
  constexpr Vertex b{-4, 5, 6};
  CHECK(a + b == Vertex{-3, 3, 9});
  CHECK(a - b == Vertex{5, -7, -3});
  CHECK(-a == Vertex{-1, 2, -3});
  CHECK(a != b);
  CHECK(Vertex{1, 2, 3} != Vertex{1, 2, 4});
  CHECK(Vertex{1, 2, 3} != Vertex{1, 4, 3});
  CHECK(Vertex{1, 2, 3} != Vertex{4, 2, 3});
  CHECK(dot_product(a, b) == 4);
  CHECK(cross(a, b) == Vertex{-27, -18, -3});
  CHECK(dot_product(cross(a, b), a) == 0);
}

TEST_CASE(
    "incidences and normals convert both ways, and opposite incidences have opposite normals") {
  CHECK(incidence_normal(no_incidence) == Vertex{0, 0, 0});
  for_each_incidence([](Incidence incidence) {
    CHECK(incidence_of(incidence_normal(incidence)) == incidence);
    CHECK(incidence_normal(opposite(incidence)) == -incidence_normal(incidence));
    CHECK(incidence_normal(incidence) != Vertex{0, 0, 0});
  });
}

TEST_CASE("there are 6 axis, 12 diagonal and 8 corner incidences") {
  int count[4] = {};
  for_each_incidence(
      [&](Incidence incidence) { ++count[squared_length(incidence_normal(incidence))]; });
  CHECK(count[1] == 6);
  CHECK(count[2] == 12);
  CHECK(count[3] == 8);
}

TEST_CASE("links are 12 diagonal vectors and 6 axis vectors of length 2, all different") {
  int diagonals = 0;
  int axes = 0;
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex vector = link_vector(link);
    diagonals += squared_length(vector) == 2 && odd_coordinates(vector) == 2;
    axes += squared_length(vector) == 4 && odd_coordinates(vector) == 0;
    CHECK(detail::derive::link_of(detail::link_table, vector) == link);
  }
  CHECK(diagonals == 12);
  CHECK(axes == 6);
}

TEST_CASE("the opposite of a link has the opposite vector") {
  for (Link link = 0; link < link_codes; ++link)
    CHECK(link_vector(opposite_link(link)) == -link_vector(link));
}

TEST_CASE("link_of() rejects vectors that are no link") {
  CHECK(detail::derive::link_of(detail::link_table, {0, 0, 0}) == link_codes);
  CHECK(detail::derive::link_of(detail::link_table, {1, 1, 1}) == link_codes);
  CHECK(detail::derive::link_of(detail::link_table, {2, 2, 0}) == link_codes);
}

TEST_CASE("the directions of an incidence are exactly the links in its planes") {
  for_each_incidence([](Incidence incidence) {
    for (Link link = 0; link < link_codes; ++link) {
      const Direction direction = direction_of(incidence, link);
      const bool is_in_plane = dot_product(link_vector(link), incidence_normal(incidence)) == 0;
      CHECK((direction != no_direction) == is_in_plane);
      if (!is_in_plane) continue;
      CHECK(direction < direction_count(incidence));
      CHECK(link_of(incidence, direction) == link);
      CHECK(direction_vector(incidence, direction) == link_vector(link));
    }
  });
}

TEST_CASE("directions are counter-clockwise seen from the tip of the normal") {
  for_each_incidence([](Incidence incidence) {
    const Direction count = direction_count(incidence);
    for (Direction direction = 0; direction < count; ++direction) {
      const Vertex here = direction_vector(incidence, direction);
      // The first half of the directions from here is on the left, the second half on the right.
      for (int steps = 1; steps < count; ++steps) {
        const auto other = static_cast<Direction>((direction + steps) % count);
        const int side = dot_product(cross(here, direction_vector(incidence, other)),
                                     incidence_normal(incidence));
        CHECK((side > 0) == (2 * steps < count));
        CHECK((side == 0) == (2 * steps == count));
      }
    }
  });
}

TEST_CASE("the direction half a revolution further is the opposite direction") {
  for_each_incidence([](Incidence incidence) {
    for (Direction direction = 0; direction < direction_count(incidence); ++direction)
      CHECK(direction_vector(incidence, opposite_direction(incidence, direction)) ==
            -direction_vector(incidence, direction));
  });
}

TEST_CASE("turn() returns the shorter rotation from one direction to another") {
  for_each_incidence([](Incidence incidence) {
    const int count = direction_count(incidence);
    for (Direction from = 0; from < count; ++from)
      for (Direction to = 0; to < count; ++to) {
        const int turned = turn(incidence, from, to);
        CHECK((from + turned + count) % count == to);
        CHECK(turned >= -count / 2);
        CHECK(turned < count / 2);
      }
  });
}

TEST_CASE("links derived at run time equal the compile-time links") {
  LinkTable derived{};
  derived = detail::derive::link_table();  // a constant would be derived by the compiler
  for (Link link = 0; link < link_codes; ++link)
    CHECK(detail::derive::link_of(derived, detail::derive::link_vector(detail::link_table, link)) ==
          link);
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    CHECK(derived.direction_count[incidence] == detail::link_table.direction_count[incidence]);
    for (int i = 0; i < max_directions / 2; ++i)
      CHECK(derived.link[incidence][i] == detail::link_table.link[incidence][i]);
  }
}
