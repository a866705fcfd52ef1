// Corners in 64 bits, and passes as corner passes: what the sweep of a host builds on.
#include <doctest/doctest.h>

#include <discmc/host/corner_pass.hpp>

#include <algorithm>

#include "oracle/neighbourhoods.hpp"

using namespace discmc;
using namespace discmc::reference;
using trace::CornerCode;
using trace::CornerPass;

namespace {

CornerCode corner(const Vertex& at, Link onwards) {
  return CornerCode(CornerCode::position(at) + CornerCode::sides(4, 17, onwards, true));
}

// What has been put into the queues at a vertex and taken out, by queue.
struct Ends {
  uint32_t put[trace::inner_queue + 1] = {};
  uint32_t taken[trace::inner_queue + 1] = {};

  void pass(trace::Port port) {
    if (trace::is_entry(port))
      ++put[port / 2];
    else
      ++taken[port / 2];
  }
};

}  // namespace

TEST_CASE("a corner tells what it was made of, wherever it is") {
  for (const Vertex at : {Vertex{-1, -1, -1}, Vertex{0, 65531, 7}, Vertex{65531, -1, 65519}}) {
    const CornerCode code = corner(at, 5);
    CHECK(code.vertex() == at);
    CHECK(code.incidence() == 4);
    CHECK(code.came() == 17);
    CHECK(code.onwards() == 5);
    CHECK(code.is_origin());
  }
  CHECK(!CornerCode(CornerCode::sides(26, 17, 17, false)).is_origin());
}

TEST_CASE("the order of corners is that of their vertices") {
  const Vertex some[] = {{9, 9, -1}, {9, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}};
  for (const Vertex& a : some)
    for (const Vertex& b : some)
      CHECK((corner(a, 17).bits() < corner(b, 17).bits()) == precedes(a, b));
}

TEST_CASE("links are counted between any two corners of a side") {
  for (Link link = 0; link < link_codes; ++link)
    for (const uint32_t length : {1U, 2U, 255U, 8191U, 16000U}) {
      const Vertex from{33000, 33000, 33000};
      Vertex to = from;
      move(to, link, length);
      CHECK(links_between(corner(from, link), corner(to, 0)) == length);
    }
}

TEST_CASE("at no vertex is more than one end put into a queue, or taken out of it") {
  uint32_t max_passes = 0;
  for (int axis = 0; axis < 3; ++axis)
    for_each_neighbourhood(axis, [&](const trace::PassList& list) {
      Ends ends;
      uint32_t passes = 0;
      for (int i = 0; i < list.count; ++i) {
        CornerPass made[CornerPass::max_of_pass] = {};
        const uint32_t count = trace::corner_passes(list.pass[i], axis, made);
        for (uint32_t k = 0; k < count; ++k) {
          const bool puts_in = trace::is_entry(made[k].in), puts_out = trace::is_entry(made[k].out);
          ends.pass(made[k].in);
          ends.pass(made[k].out);
          const bool is_origin = CornerCode(made[k].corner).is_origin();
          if (is_origin != (puts_in && puts_out) || (is_origin && k > 0)) FAIL("an origin");
          if ((made[k].joins == 1) != (!puts_in && !puts_out)) FAIL("a join");
          if (made[k].if_straight == -1 && puts_in == puts_out) FAIL("a straight pass");
          // The end that is passed on within the vertex has come and gone.
          const bool is_last = k + 1 == count;
          const uint32_t inside = ends.put[trace::inner_queue] - ends.taken[trace::inner_queue];
          if (inside != (is_last ? 0U : 1U)) FAIL("an end within the vertex");
        }
        passes += count;
      }
      max_passes = std::max(max_passes, passes);
      const auto is_once = [](uint32_t count) { return count <= 1; };
      if (!std::all_of(ends.put, ends.put + trace::inner_queue, is_once)) FAIL("two ends put");
      if (!std::all_of(ends.taken, ends.taken + trace::inner_queue, is_once))
        FAIL("two ends taken");
    });
  CHECK(max_passes <= trace::PassList::most * CornerPass::max_of_pass);
}
