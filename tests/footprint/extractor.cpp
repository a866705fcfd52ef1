// Flash: the table and an extractor of 8-bit samples, with a sink that throws everything away.
#include <discmc/extractor.hpp>

using namespace discmc;

static Answer take(void*, const Event&) {
  return Answer::taken;
}

extern "C" Status run(Extractor16& extractor, const Limits& limits, Memory memory,
                      const uint8_t* row) {
  Status status = extractor.start(limits, 128, memory, {nullptr, take});
  if (status == Status::ok) status = extractor.push(row, limits.width).status;
  if (status == Status::more) status = extractor.resume();
  return status == Status::ok ? extractor.finish() : status;
}
