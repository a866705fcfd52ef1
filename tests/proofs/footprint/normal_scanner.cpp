// Flash: a scanner of 8-bit samples that sends normals.
#include <discmc/encoder.hpp>
#include <discmc/normal_extractor.hpp>

using namespace discmc;
using Scanner = NormalExtractor16<uint8_t>;

// The parameters of a firmware, fixed at compile time.
constexpr Limits limits{64, 64};
constexpr Capacities capacities =
    detail::sizing::default_capacities<uint16_t, detail::trace::GradientIntake<uint8_t>>(limits,
                                                                                         28 * 1024);

extern "C" Status run(Scanner& extractor, Encoder& encoder, const ByteOutput& output,
                      const StreamLabel& label, Memory memory, const uint8_t* row) {
  encoder.encode_normals();
  Status status = encoder.start(label, output);
  extractor.set_spacing(label.spacing_nm);
  if (status == Status::ok)
    status = extractor.start(limits, capacities, 128, memory, make_sink(encoder));
  if (status == Status::ok) status = extractor.push(row, limits.width).status;
  if (status == Status::suspended) status = extractor.resume();
  return status == Status::ok ? extractor.finish() : status;
}
