// discmc.h in terms of the C++ library: the encoder with normals. A file of its own, so that plain
// scanners do not link it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/encoder.hpp>

namespace discmc {

namespace {

static_assert(fits<Encoder, discmc_normal_encoder> &&
                  fits<Checkpoint<Encoder>, discmc_normal_encoder_checkpoint>,
              "the sizes in discmc.h are enough and not much more");

Encoder& cpp(discmc_normal_encoder* encoder) {
  return *reinterpret_cast<Encoder*>(encoder);
}
const Encoder& cpp(const discmc_normal_encoder* encoder) {
  return *reinterpret_cast<const Encoder*>(encoder);
}

}  // namespace

extern "C" {

discmc_status discmc_normal_encoder_start(discmc_normal_encoder* encoder,
                                          const discmc_stream_label* label,
                                          discmc_byte_output output) {
  cpp(encoder).encode_normals();
  return c(cpp(encoder).start(cpp(*label), cpp(output)));
}
discmc_answer discmc_normal_encoder_take(void* encoder, const discmc_event* event) {
  return static_cast<discmc_answer>(cpp(static_cast<discmc_normal_encoder*>(encoder))
                                        .take(*reinterpret_cast<const Event*>(event)));
}
discmc_status discmc_normal_encoder_tell(discmc_normal_encoder* encoder,
                                         const discmc_application_record* record) {
  return c(cpp(encoder).tell(cpp(*record)));
}
discmc_status discmc_normal_encoder_append(discmc_normal_encoder* encoder,
                                           const discmc_records_packet* packet) {
  return c(cpp(encoder).append(cpp(*packet)));
}
void discmc_normal_encoder_set_output(discmc_normal_encoder* encoder, discmc_byte_output output) {
  cpp(encoder).set_output(cpp(output));
}
uint8_t discmc_normal_encoder_flush(discmc_normal_encoder* encoder) {
  return cpp(encoder).flush() ? 1 : 0;
}
uint64_t discmc_normal_encoder_bytes(const discmc_normal_encoder* encoder) {
  return cpp(encoder).bytes();
}
discmc_status discmc_normal_encoder_save(const discmc_normal_encoder* encoder,
                                         discmc_normal_encoder_checkpoint* checkpoint) {
  return c(cpp(encoder).save(*reinterpret_cast<Checkpoint<Encoder>*>(checkpoint)));
}
discmc_status discmc_normal_encoder_restore(discmc_normal_encoder* encoder,
                                            const discmc_normal_encoder_checkpoint* checkpoint,
                                            discmc_byte_output output) {
  cpp(encoder).encode_normals();
  return c(
      cpp(encoder).restore(*reinterpret_cast<const Checkpoint<Encoder>*>(checkpoint), cpp(output)));
}

}  // extern "C"

}  // namespace discmc
