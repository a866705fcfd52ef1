// Flash: a receiver, with a sink that discards all events.
#include <discmc/receiver.hpp>

using namespace discmc;

static SinkResult accept(void*, const Event&) {
  return SinkResult::accepted;
}

extern "C" Status run(Receiver& receiver, Memory memory, const uint8_t* bytes, size_t count) {
  Status status = receiver.start(memory, {nullptr, accept});
  if (status == Status::ok) status = receiver.push(bytes, count).status;
  return status == Status::ok ? receiver.finish() : status;
}
