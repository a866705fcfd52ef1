// discmc.h in terms of the C++ library: the encoder of a part. A file of its own, so that scanners
// do not link it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/encoder.hpp>

namespace discmc {

namespace {

static_assert(fits<PartEncoder, discmc_part_encoder>, "the size in discmc.h is enough");

PartEncoder& cpp(discmc_part_encoder* encoder) {
  return *reinterpret_cast<PartEncoder*>(encoder);
}

}  // namespace

extern "C" {

discmc_status discmc_part_encoder_start(discmc_part_encoder* encoder,
                                        const discmc_stream_label* label,
                                        discmc_byte_output output) {
  return c(cpp(encoder).start(cpp(*label), cpp(output)));
}
discmc_answer discmc_part_encoder_take(void* encoder, const discmc_event* event) {
  return static_cast<discmc_answer>(
      cpp(static_cast<discmc_part_encoder*>(encoder)).take(*reinterpret_cast<const Event*>(event)));
}
uint8_t discmc_part_encoder_flush(discmc_part_encoder* encoder) {
  return cpp(encoder).flush() ? 1 : 0;
}

}  // extern "C"

}  // namespace discmc
