// Flash: a scanner, that is an extractor of 8-bit samples and its encoder. With EXTRACTOR, the
// compiler may inline that extractor.
#include <discmc/encoder.hpp>
#ifdef EXTRACTOR
#include <discmc/trace/extractor_definitions.hpp>
#else
#include <discmc/extractor.hpp>
#define EXTRACTOR Extractor16
#endif

using namespace discmc;

// The parameters of a firmware, fixed at compile time.
constexpr Limits limits{64, 64};
constexpr Capacities capacities = Extractor16::default_capacities(limits, 12 * 1024);

extern "C" Status run(EXTRACTOR& extractor, Encoder& encoder, const ByteOutput& output,
                      const StreamLabel& label, Memory memory, const uint8_t* row) {
  Status status = encoder.start(label, output);
  if (status == Status::ok)
    status = extractor.start(limits, capacities, 128, memory, make_sink(encoder));
  if (status == Status::ok) status = extractor.push(row, limits.width).status;
  if (status == Status::suspended) status = extractor.resume();
  return status == Status::ok ? extractor.finish() : status;
}
