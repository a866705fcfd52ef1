// Flash: a slice encoder of 8-bit samples with fractions.
#include <discmc/fraction_slice_encoder.hpp>

using namespace discmc;

extern "C" Status run(FractionSliceEncoder<uint8_t>& encoder, const ByteOutput& output,
                      const SliceEncoderConfig& config, Memory memory, const uint8_t* row) {
  Status status = encoder.start(config, memory, output);
  if (status == Status::ok) status = encoder.push(row, config.limits.width).status;
  if (status == Status::suspended) status = encoder.resume();
  return status == Status::ok ? encoder.finish() : status;
}
