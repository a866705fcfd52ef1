#include <discmc/c/encoder_kind.hpp>
#include <discmc/c/values.hpp>

namespace discmc {

extern "C" {

discmc_status discmc_encoder_start(discmc_encoder** encoder, const discmc_encoder_config* config) {
  return start<discmc_encoder>(encoder, *config, [&](discmc_encoder& object, Memory) {
    config->kind->prepare(object.encoder);
    return object.encoder.start(cpp(config->label), cpp(config->output));
  });
}
discmc_status discmc_encoder_restore(discmc_encoder** encoder,
                                     const discmc_encoder_config* config) {
  return restore<discmc_encoder>(encoder, *config, [&](discmc_encoder& object, Memory) {
    const Status status = object.encoder.restore(cpp(config->output));
    if (status == Status::ok) config->kind->prepare(object.encoder);
    return status;
  });
}
discmc_status discmc_encoder_save(discmc_encoder* encoder, discmc_memory* part) {
  Memory object;
  *part = encoder->memory;  // as long as the config's memory, at any alignment
  return c(encoder->encoder.save(&object));
}

// The header of a `start` event is the beginning of a C++ header; only that part is read.
discmc_sink_result discmc_encoder_accept(void* encoder, const discmc_event* event) {
  if (encoder == nullptr) return DISCMC_SINK_NOT_STARTED;  // the sink lacks its context
  Encoder& object = static_cast<discmc_encoder*>(encoder)->encoder;
  return static_cast<discmc_sink_result>(object.accept(reinterpret_cast<const Event&>(*event)));
}
discmc_status discmc_encoder_write_record(discmc_encoder* encoder,
                                          const discmc_application_record* record) {
  return c(encoder->encoder.write_record(cpp(*record)));
}
discmc_status discmc_encoder_flush(discmc_encoder* encoder) {
  return c(encoder->encoder.flush());
}
void discmc_encoder_set_output(discmc_encoder* encoder, discmc_byte_output output) {
  encoder->encoder.set_output(cpp(output));
}
uint64_t discmc_encoder_stream_bytes(const discmc_encoder* encoder) {
  return encoder->encoder.bytes();
}

}  // extern "C"

static_assert(DISCMC_ENCODER_BYTES >= bytes_with_object(sizeof(discmc_encoder), 0),
              "the size in sizes.h suffices");

}  // namespace discmc

const discmc_encoder_kind discmc_regions = discmc::encoder_kind(0, [](discmc::Encoder&) {});
