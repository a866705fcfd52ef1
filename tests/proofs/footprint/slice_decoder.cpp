// Flash: a slice decoder, with a sink that discards all events.
#include <discmc/slice_decoder.hpp>

using namespace discmc;

static SinkResult accept(void*, const RowEvent&) {
  return SinkResult::accepted;
}

extern "C" Status run(SliceDecoder& decoder, Memory memory, const uint8_t* bytes, size_t count) {
  Status status = decoder.start(memory, {nullptr, accept});
  if (status == Status::ok) status = decoder.push(bytes, count).status;
  return status == Status::ok ? decoder.finish() : status;
}
