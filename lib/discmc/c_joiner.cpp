// discmc.h in terms of the C++ library: the joiner. A file of its own, so that firmware which only
// scans does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/joiner.hpp>

namespace discmc {

namespace {

static_assert(fits<SinkAdapter<Joiner>, discmc_joiner>, "the size in discmc.h is enough");
static_assert(DISCMC_SWEEP_ORDER == static_cast<int>(InputOrder::sweep) &&
                  DISCMC_ANY_ORDER == static_cast<int>(InputOrder::any),
              "enumerations are in the same order");
static_assert(DISCMC_JOINER_MINIMUM_BYTES == Joiner::minimum_bytes() &&
                  DISCMC_JOINER_BYTES_FOR(7, 11) == Joiner::bytes_for({7, 11}) &&
                  DISCMC_JOIN_MAX_FRAGMENTS_ == JoinCapacities::max_fragments,
              "the constants of sizes.h are what the functions give");

SinkAdapter<Joiner>& adapter(discmc_joiner* joiner) {
  return *reinterpret_cast<SinkAdapter<Joiner>*>(joiner);
}
Joiner& cpp(discmc_joiner* joiner) {
  return adapter(joiner).object;
}
const Joiner& cpp(const discmc_joiner* joiner) {
  return reinterpret_cast<const SinkAdapter<Joiner>*>(joiner)->object;
}
discmc_join_capacities c(const JoinCapacities& from) {
  return {from.fragments, from.runs};
}

}  // namespace

extern "C" {

void discmc_add_statistics(discmc_statistics* sum, const discmc_statistics* other) {
  // Totals have one layout on both sides (c_api.cpp).
  add(*reinterpret_cast<Statistics*>(sum), *reinterpret_cast<const Statistics*>(other));
}

uint64_t discmc_joiner_bytes_for(const discmc_join_capacities* capacities) {
  return Joiner::bytes_for({capacities->fragments, capacities->runs});
}
uint64_t discmc_joiner_minimum_bytes(void) {
  return Joiner::minimum_bytes();
}
discmc_join_capacities discmc_joiner_default_capacities(uint64_t bytes) {
  return c(Joiner::default_capacities(bytes));
}

discmc_status discmc_joiner_start(discmc_joiner* joiner, const discmc_join_capacities* capacities,
                                  discmc_memory memory, const discmc_sink* sink, uint8_t order) {
  const JoinCapacities split = capacities == nullptr
                                   ? Joiner::default_capacities(memory.bytes)
                                   : JoinCapacities{capacities->fragments, capacities->runs};
  return adapter(joiner).start_to(*sink, [&](const Sink& to) {
    return cpp(joiner).start(split, {memory.data, memory.bytes}, to,
                             static_cast<InputOrder>(order));
  });
}
discmc_answer discmc_joiner_take(void* joiner, const discmc_event* event) {
  return static_cast<discmc_answer>(
      cpp(static_cast<discmc_joiner*>(joiner)).take(*reinterpret_cast<const Event*>(event)));
}
discmc_status discmc_joiner_finish(discmc_joiner* joiner) {
  return static_cast<discmc_status>(cpp(joiner).finish());
}
discmc_join_report discmc_joiner_report(const discmc_joiner* joiner) {
  const JoinReport& from = cpp(joiner).report();
  return {from.fragments, from.invalid, from.regions, from.rings, from.unmatched, from.passed};
}
discmc_join_capacities discmc_joiner_capacities(const discmc_joiner* joiner) {
  return c(cpp(joiner).capacities());
}
discmc_join_capacities discmc_joiner_high_water(const discmc_joiner* joiner) {
  return c(cpp(joiner).high_water());
}

}  // extern "C"

}  // namespace discmc
