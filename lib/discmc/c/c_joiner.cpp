#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/joiner.hpp>

struct discmc_joiner {
  discmc::WithSink<discmc::Joiner> with_sink;
};

namespace discmc {

static_assert(red_zone_bytes > 0 ||
                  DISCMC_JOINER_BYTES(7) >=
                      bytes_with_object(sizeof(discmc_joiner), Joiner::bytes_for({7, 56})),
              "the size in sizes.h suffices");

extern "C" {

discmc_status discmc_joiner_start(discmc_joiner** joiner, const discmc_joiner_config* config) {
  Memory rest;
  auto* const object = begin<discmc_joiner>(config->memory, rest);
  if (object == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  const Status status = object->with_sink.object.start(
      rest, object->with_sink.set_sink(config->sink), static_cast<InputOrder>(config->order));
  if (status == Status::ok) *joiner = object;
  return c(status);
}
discmc_sink_result discmc_joiner_accept(void* joiner, const discmc_event* event) {
  if (joiner == nullptr) return DISCMC_SINK_NOT_STARTED;  // the sink lacks its context
  Joiner& object = static_cast<discmc_joiner*>(joiner)->with_sink.object;
  return static_cast<discmc_sink_result>(object.accept(reinterpret_cast<const Event&>(*event)));
}
discmc_status discmc_joiner_finish(discmc_joiner* joiner) {
  return c(joiner->with_sink.object.finish());
}
discmc_joiner_info discmc_joiner_get_info(const discmc_joiner* joiner) {
  const Joiner& object = joiner->with_sink.object;
  const JoinReport& report = object.report();
  return {report.received,
          report.invalid,
          report.regions,
          report.rings,
          report.unmatched,
          report.short_of_memory,
          object.capacities().fragments,
          object.capacities().runs,
          object.peaks().fragments,
          object.peaks().runs};
}

}  // extern "C"

}  // namespace discmc
