// A ring begins at its last vertex, which is a top and is passed once.
#include <discmc/geometry/loop_facets.hpp>
#include <discmc/trace/delivery.hpp>

#include "oracle/neighbourhoods.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// Whether a chain has a top between these links.
bool is_top(const Vertex& came, const Vertex& goes) {
  return precedes({0, 0, 0}, came) && precedes(goes, {0, 0, 0});
}

}  // namespace

TEST_CASE("each plane has at most one ring top at each vertex") {
  uint32_t neighbourhoods = 0, tops = 0, most = 0;
  for (int axis = 0; axis < 3; ++axis)
    for_each_neighbourhood(axis, [&](const detail::trace::PassList& passes) {
      ++neighbourhoods;
      uint32_t tops_of[incidence_codes] = {};
      for (int i = 0; i < passes.count; ++i) {
        const detail::trace::Pass& pass = passes.pass[i];
        if (!is_top(link_vector(pass.incoming), link_vector(pass.outgoing))) continue;
        ++tops;
        most = std::max(most, ++tops_of[pass.incidence]);
      }
    });
  CHECK(neighbourhoods == 3 << 17);
  CHECK(tops > neighbourhoods / 2);
  CHECK(most == 1);
}

TEST_CASE("each incidence occurs at most once around each centroid") {
  for (unsigned configuration = 0; configuration < 256; ++configuration) {
    const Loops loops = detail::derive::loops(static_cast<Configuration>(configuration));
    for (int n = 0; n < loops.count; ++n) {
      const LoopFacets facets = facets_of(loops.loop[n]);
      if (!facets.is_fan) continue;
      bool has_come[incidence_codes] = {};
      for (int link = 0; link < facets.loop.count; ++link) {
        if (facets.behind(link) == facets.behind(link - 1)) continue;  // no spoke
        CHECK(!has_come[facets.behind(link)]);
        has_come[facets.behind(link)] = true;
      }
    }
  }
}
