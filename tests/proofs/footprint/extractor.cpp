// Flash: an extractor of 8-bit samples, with a sink that discards all events.
#include <discmc/extractor.hpp>

using namespace discmc;

static SinkResult accept(void*, const Event&) {
  return SinkResult::accepted;
}

// The parameters of a firmware, fixed at compile time.
constexpr Limits limits{64, 64};
constexpr Capacities capacities = Extractor16::default_capacities(limits, 12 * 1024);

extern "C" Status run(Extractor16& extractor, Memory memory, const uint8_t* row) {
  Status status = extractor.start(limits, capacities, 128, memory, {nullptr, accept});
  if (status == Status::ok) status = extractor.push(row, limits.width).status;
  if (status == Status::suspended) status = extractor.resume();
  return status == Status::ok ? extractor.finish() : status;
}
