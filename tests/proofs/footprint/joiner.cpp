// Flash: a joiner, with a sink that discards all events.
#include <discmc/joiner.hpp>

using namespace discmc;

static SinkResult accept(void*, const Event&) {
  return SinkResult::accepted;
}

extern "C" Status run(Joiner& joiner, Memory memory, const Event& event) {
  Status status = joiner.start(memory, {nullptr, accept}, InputOrder::sweep);
  if (status == Status::ok && joiner.accept(event) == SinkResult::busy) status = Status::suspended;
  return status == Status::ok ? joiner.finish() : status;
}
