// The 64-bit codes of corners on which the host's sweep relies.
#include "host/corner_code.hpp"
#include "test.hpp"

using namespace discmc;
using host::CornerCode;

namespace {

CornerCode corner(const Vertex& at, Link onwards) {
  return CornerCode(CornerCode::position(at) + CornerCode::links(17, onwards) +
                    (4U << CornerCode::incidence_shift));
}

}  // namespace

TEST_CASE("a corner code stores vertex, incidence and links for any vertex in range") {
  for (const Vertex at : {Vertex{-1, -1, -1}, Vertex{0, 65531, 7}, Vertex{65531, -1, 65519}}) {
    const CornerCode code = corner(at, 5);
    CHECK(code.vertex() == at);
    CHECK(code.incidence() == 4);
    CHECK(code.incoming() == 17);
    CHECK(code.onwards() == 5);
  }
}

TEST_CASE("corner codes sort in the order of their vertices") {
  const Vertex some[] = {{9, 9, -1}, {9, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}};
  for (const Vertex& a : some)
    for (const Vertex& b : some)
      CHECK((corner(a, 17).bits() < corner(b, 17).bits()) == precedes(a, b));
}

TEST_CASE("links_between() returns the number of links between two corners of a side") {
  for (Link link = 0; link < link_codes; ++link)
    for (const uint32_t length : {1U, 2U, 255U, 8191U, 16000U}) {
      const Vertex from{33000, 33000, 33000};
      Vertex to = from;
      translate(to, link, length);
      CHECK(links_between(corner(from, link), corner(to, 0)) == length);
    }
}
