// Flash: a decoder, with a sink that discards all events.
#include <discmc/decoder.hpp>

using namespace discmc;

static SinkResult accept(void*, const Event&) {
  return SinkResult::accepted;
}

extern "C" Status run(Decoder& decoder, const uint8_t* bytes, size_t count) {
  Status status = decoder.start({nullptr, accept});
  if (status == Status::ok) status = decoder.push(bytes, count).status;
  return status == Status::ok ? decoder.finish() : status;
}
