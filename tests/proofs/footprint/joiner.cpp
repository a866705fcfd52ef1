// Flash: a joiner, with a sink that throws everything away.
#include <discmc/joiner.hpp>

using namespace discmc;

static SinkResult take(void*, const Event&) {
  return SinkResult::accepted;
}

extern "C" Status run(Joiner& joiner, Memory memory, const Event& event) {
  Status status = joiner.start(memory, {nullptr, take}, InputOrder::sweep);
  if (status == Status::ok && joiner.take(event) == SinkResult::busy) status = Status::suspended;
  return status == Status::ok ? joiner.finish() : status;
}
