#include <discmc/c/encoder_kind.hpp>
#include <discmc/c/values.hpp>

namespace discmc {

namespace {

// A header of C's, which may be the caller's, is the beginning of one of C++'s.
StreamHeader whole(const discmc_stream_header& from) {
  StreamHeader header;
  for (size_t i = 0; i < sizeof from; ++i)
    reinterpret_cast<uint8_t*>(&header)[i] = reinterpret_cast<const uint8_t*>(&from)[i];
  return header;
}

}  // namespace

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
    config->kind->prepare(object.encoder);
    return object.encoder.continue_to(cpp(config->output));
  });
}
discmc_status discmc_encoder_save(discmc_encoder* encoder, discmc_memory* part) {
  (void)encoder->seal.close(encoder->kind->object_bytes);
  *part = encoder->seal.memory;  // as long as that of the config, wherever the object lies in it
  return DISCMC_OK;
}

discmc_sink_result discmc_encoder_take(void* encoder, const discmc_event* event) {
  Encoder& object = static_cast<discmc_encoder*>(encoder)->encoder;
  const Event& same = reinterpret_cast<const Event&>(*event);
  if (same.kind != Event::Kind::start) return static_cast<discmc_sink_result>(object.take(same));
  const StreamHeader header = whole(*event->of.header);
  Event start = same;
  start.header = &header;
  return static_cast<discmc_sink_result>(object.take(start));
}

discmc_status discmc_encoder_write_record(discmc_encoder* encoder,
                                          const discmc_application_record* record) {
  return c(encoder->encoder.tell(cpp(*record)));
}
discmc_status discmc_encoder_flush(discmc_encoder* encoder) {
  return encoder->encoder.flush() ? DISCMC_OK : DISCMC_SUSPENDED;
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
