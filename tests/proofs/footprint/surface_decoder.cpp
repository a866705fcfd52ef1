// Flash: a surface decoder, with a sink that throws everything away.
#include <discmc/surface_decoder.hpp>

using namespace discmc;

static SinkResult take(void*, const Event&) {
  return SinkResult::accepted;
}

extern "C" Status run(SurfaceDecoder& decoder, Memory memory, const uint8_t* bytes, size_t count) {
  Status status = decoder.start(memory, {nullptr, take});
  if (status == Status::ok) status = decoder.push(bytes, count).status;
  return status == Status::ok ? decoder.finish() : status;
}
