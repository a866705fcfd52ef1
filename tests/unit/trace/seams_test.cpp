// The slabs of a volume, joined, equal the whole volume; their counts add up to its counts.
#include <discmc/normal_extractor.hpp>
#include "host/host_extractor.hpp"

#include "oracle/agreement.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// Both slabs at a seam count parts of its cells. Sums that are not whole are not compared.
bool adds_up(uint64_t sum, uint64_t whole, size_t slabs) {
  return sum <= whole && whole - sum < slabs;
}

}  // namespace

TEST_CASE("slabs join to the whole surface, and their counts add up except at seams") {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    const BitVolume volume = random({9, 8, 6}, 20 + 18 * static_cast<uint32_t>(seed), seed);
    for (const Border border : {Border::closed, Border::open})
      for (const uint32_t slices : {1U, 2U, 4U}) {
        INFO("seed ", seed, ", is_closed ", border == Border::closed, ", slices ", slices);
        const std::vector<Collector> slabs = scan_slabs<uint16_t>(volume, border, slices, 20000);
        CHECK(unlike_joined(slabs, merge(volume, border == Border::closed)) == "");
        Statistics sum{};
        for (const Collector& slab : slabs) {
          sum.cells += slab.statistics().cells;
          sum.facets += slab.statistics().facets;
          sum.classic_triangles += slab.statistics().classic_triangles;
        }
        const Statistics whole = scan<uint16_t>(volume, {border}).statistics();
        CHECK(adds_up(sum.cells, whole.cells, slabs.size()));
        CHECK(adds_up(sum.facets, whole.facets, slabs.size()));
        CHECK(adds_up(sum.classic_triangles, whole.classic_triangles, slabs.size()));
      }
  }
}

TEST_CASE("a slab without slices of its own has no surface, for any slices around the slab") {
  struct Below {  // the layer below the first slice of a closed border is not at a seam
    Border border;
    bool continues_below;
  };
  const BitVolume full = box({5, 4, 2}, {0, 0, 0}, {4, 3, 1}), rough = random({5, 4, 2}, 128, 1);
  for (const BitVolume* const volume : {&full, &rough})
    for (const Below& below :
         {Below{Border::closed, true}, {Border::open, false}, {Border::open, true}}) {
      const auto [border, continues_below] = below;
      Limits limits{5, 4, border};
      limits.slab.first = continues_below ? 7 : 0;
      limits.slab.continues_below = continues_below;
      limits.slab.continues_above = true;
      Block block(Extractor16::bytes_for(limits, ample));
      EventLog log;
      Extractor16 extractor;
      require_ok(extractor.start(limits, ample, 1, block.memory(), make_sink(log)));
      require_ok(extractor.push(volume->on.data(), continues_below ? 40 : 20).status);
      finish_all(extractor);
      const Collector slab = collected(log.events, limits.slab);
      CHECK(slab.regions().empty());
      CHECK(slab.statistics().cells == 0);
      CHECK(slab.statistics().links == 0);
    }
}

TEST_CASE_TEMPLATE("a slab accepts slices up to the last number and refuses further slices",
                   Scanner, Extractor16, Extractor32, NormalExtractor16<uint8_t>, HostExtractor) {
  constexpr uint32_t slice = 3 * 2, own = 3;
  const std::vector<uint8_t> slices((own + 2) * slice, 1);
  Limits limits{3, 2};
  limits.slab = {Limits::max_slices - own, true, false};
  Block block(200000);
  EventLog log;
  Scanner scanner;
  require_ok(scanner.start(limits, 1, block.memory(), make_sink(log)));
  const PushResult at_once = scanner.push(slices.data(), (own + 2) * slice);
  CHECK(at_once.status == Status::too_many_slices);
  CHECK(at_once.samples == (own + 1) * slice);
  require_ok(scanner.finish());
  CHECK(log.events.back().event().slice == own);

  require_ok(scanner.reset());
  for (uint32_t pushed = 0; pushed < own + 1; ++pushed)
    CHECK(scanner.push(slices.data(), slice).status == Status::ok);
  CHECK(scanner.skip_row(Substitute::off).status == Status::too_many_slices);
  require_ok(scanner.finish());
}
