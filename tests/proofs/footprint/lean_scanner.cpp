// Flash: a scanner without the features whose bits LEFT_OUT has.
#include <discmc/encoder.hpp>
#include <discmc/trace/extractor_definitions.hpp>

using namespace discmc;

struct Features : AllFeatures {
  static constexpr bool open_border = (LEFT_OUT & 1) == 0;
  static constexpr bool slabs = (LEFT_OUT & 2) == 0;
  static constexpr bool cell_counts = (LEFT_OUT & 4) == 0;
  static constexpr bool holes_wait = (LEFT_OUT & 8) == 0;
};

// The parameters of a firmware, fixed at compile time.
constexpr Limits limits{64, 64};
constexpr Capacities capacities = Extractor16::default_capacities(limits, 12 * 1024);

extern "C" Status run(Extractor<uint16_t, Features>& extractor, Encoder& encoder,
                      const ByteOutput& output, const StreamLabel& label, Memory memory,
                      const uint8_t* row) {
  Status status = encoder.start(label, output);
  if (status == Status::ok)
    status = extractor.start(limits, capacities, 128, memory, make_sink(encoder));
  if (status == Status::ok) status = extractor.push(row, limits.width).status;
  if (status == Status::suspended) status = extractor.resume();
  return status == Status::ok ? extractor.finish() : status;
}
