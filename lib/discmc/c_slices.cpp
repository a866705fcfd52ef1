// discmc.h in terms of the C++ library: streams of bits. A file of its own, so that firmware which
// sends regions does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_decoder.hpp>

namespace discmc {

namespace {

#define DISCMC_SAME_PLACE(member) (offsetof(RowEvent, member) == offsetof(discmc_row_event, member))
static_assert(sizeof(RowEvent) == sizeof(discmc_row_event) && DISCMC_SAME_PLACE(kind) &&
                  DISCMC_SAME_PLACE(repeated) && DISCMC_SAME_PLACE(abandoned) &&
                  DISCMC_SAME_PLACE(channel) && DISCMC_SAME_PLACE(slice) &&
                  DISCMC_SAME_PLACE(row) && DISCMC_SAME_PLACE(count) &&
                  offsetof(RowEvent, bits) == offsetof(discmc_row_event, of),
              "row events have one layout");
#undef DISCMC_SAME_PLACE
static_assert(DISCMC_ROWS_LOST == static_cast<int>(RowEvent::Kind::lost) &&
                  DISCMC_ROWS_FINISH == static_cast<int>(RowEvent::Kind::finish),
              "enumerations are in the same order");
static_assert(DISCMC_MOST_SKIPPED_ROWS == SurfaceDecoder::most_skipped_rows, "one limit");

using SliceDecoderAdapter = SinkAdapter<SliceDecoder, discmc_row_event>;
using SurfaceDecoderAdapter = SinkAdapter<SurfaceDecoder>;

static_assert(fits<SliceEncoder, discmc_slice_encoder> &&
                  fits<Checkpoint<SliceEncoder>, discmc_slice_encoder_checkpoint> &&
                  fits<SliceDecoderAdapter, discmc_slice_decoder> &&
                  fits<SurfaceDecoderAdapter, discmc_surface_decoder>,
              "the sizes in discmc.h are enough and not much more");

static_assert(DISCMC_SLICE_ENCODER_BYTES_FOR(31, 7, 0, 1) == slice_encoder_bytes({31, 7}, {0}, 1) &&
                  DISCMC_SLICE_ENCODER_BYTES_FOR(31, 7, 1, 3) ==
                      slice_encoder_bytes({31, 7}, {1}, 3) &&
                  DISCMC_SLICE_DECODER_BYTES_FOR(31, 7, 3) == slice_decoder_bytes({31, 7}, 3) &&
                  DISCMC_MINIMUM_SURFACE_BYTES(31, 7, 3) == minimum_surface_bytes({31, 7}, 3),
              "the constants of sizes.h are what the functions give; the tests have many more");

SliceEncoder& cpp(discmc_slice_encoder* encoder) {
  return *reinterpret_cast<SliceEncoder*>(encoder);
}
const SliceEncoder& cpp(const discmc_slice_encoder* encoder) {
  return *reinterpret_cast<const SliceEncoder*>(encoder);
}
SliceDecoderAdapter& adapter(discmc_slice_decoder* decoder) {
  return *reinterpret_cast<SliceDecoderAdapter*>(decoder);
}
SliceDecoder& cpp(discmc_slice_decoder* decoder) {
  return adapter(decoder).object;
}
const SliceDecoder& cpp(const discmc_slice_decoder* decoder) {
  return reinterpret_cast<const SliceDecoderAdapter*>(decoder)->object;
}
SurfaceDecoderAdapter& adapter(discmc_surface_decoder* decoder) {
  return *reinterpret_cast<SurfaceDecoderAdapter*>(decoder);
}
SurfaceDecoder& cpp(discmc_surface_decoder* decoder) {
  return adapter(decoder).object;
}
const SurfaceDecoder& cpp(const discmc_surface_decoder* decoder) {
  return reinterpret_cast<const SurfaceDecoderAdapter*>(decoder)->object;
}

}  // namespace

extern "C" {

uint64_t discmc_slice_encoder_bytes_for(const discmc_limits* limits, uint32_t key_slice_interval,
                                        uint32_t surfaces) {
  return slice_encoder_bytes(cpp(*limits), {key_slice_interval}, surfaces);
}
discmc_status discmc_slice_encoder_start(discmc_slice_encoder* encoder,
                                         const discmc_stream_header* header,
                                         uint32_t key_slice_interval, discmc_memory memory,
                                         discmc_byte_output output) {
  return c(cpp(encoder).start(cpp(*header), {key_slice_interval}, cpp(memory), cpp(output)));
}
discmc_push_result discmc_slice_encoder_push_u8(discmc_slice_encoder* encoder,
                                                const uint8_t* samples, uint32_t count,
                                                uint32_t stride) {
  return c(cpp(encoder).push(samples, count, stride));
}
discmc_push_result discmc_slice_encoder_push_u16(discmc_slice_encoder* encoder,
                                                 const uint16_t* samples, uint32_t count,
                                                 uint32_t stride) {
  return c(cpp(encoder).push(samples, count, stride));
}
discmc_push_result discmc_slice_encoder_push_i16(discmc_slice_encoder* encoder,
                                                 const int16_t* samples, uint32_t count,
                                                 uint32_t stride) {
  return c(cpp(encoder).push(samples, count, stride));
}
discmc_push_result discmc_slice_encoder_push_bits(discmc_slice_encoder* encoder,
                                                  const uint8_t* bits) {
  return c(cpp(encoder).push_bits(bits));
}
discmc_push_result discmc_slice_encoder_skip_row(discmc_slice_encoder* encoder,
                                                 uint8_t substitute) {
  return c(cpp(encoder).skip_row(static_cast<Substitute>(substitute)));
}
discmc_status discmc_slice_encoder_resume(discmc_slice_encoder* encoder) {
  return c(cpp(encoder).resume());
}
discmc_status discmc_slice_encoder_flush(discmc_slice_encoder* encoder) {
  return c(cpp(encoder).flush());
}
discmc_status discmc_slice_encoder_tell(discmc_slice_encoder* encoder,
                                        const discmc_application_record* record) {
  return c(cpp(encoder).tell(cpp(*record)));
}
void discmc_slice_encoder_set_output(discmc_slice_encoder* encoder, discmc_byte_output output) {
  cpp(encoder).set_output(cpp(output));
}
discmc_status discmc_slice_encoder_finish(discmc_slice_encoder* encoder) {
  return c(cpp(encoder).finish());
}
discmc_status discmc_slice_encoder_abandon(discmc_slice_encoder* encoder) {
  return c(cpp(encoder).abandon());
}
discmc_status discmc_slice_encoder_save(const discmc_slice_encoder* encoder,
                                        discmc_slice_encoder_checkpoint* checkpoint) {
  return c(cpp(encoder).save(*reinterpret_cast<Checkpoint<SliceEncoder>*>(checkpoint)));
}
discmc_status discmc_slice_encoder_restore(discmc_slice_encoder* encoder,
                                           const discmc_slice_encoder_checkpoint* checkpoint,
                                           discmc_memory memory, discmc_byte_output output) {
  return c(cpp(encoder).restore(*reinterpret_cast<const Checkpoint<SliceEncoder>*>(checkpoint),
                                cpp(memory), cpp(output)));
}
uint64_t discmc_slice_encoder_bytes(const discmc_slice_encoder* encoder) {
  return cpp(encoder).bytes();
}
size_t discmc_slice_encoder_bytes_used(const discmc_slice_encoder* encoder) {
  return cpp(encoder).bytes_used();
}
uint32_t discmc_slice_encoder_slices(const discmc_slice_encoder* encoder) {
  return cpp(encoder).slices();
}
uint32_t discmc_slice_encoder_rows(const discmc_slice_encoder* encoder) {
  return cpp(encoder).rows();
}

uint64_t discmc_slice_decoder_bytes_for(const discmc_limits* limits, uint32_t surfaces) {
  return slice_decoder_bytes(cpp(*limits), surfaces);
}
discmc_status discmc_slice_decoder_start(discmc_slice_decoder* decoder, discmc_memory memory,
                                         const discmc_row_sink* sink, uint8_t channel) {
  return adapter(decoder).start_to(
      *sink, [&](const RowSink& to) { return cpp(decoder).start(cpp(memory), to, channel); });
}
discmc_decoded discmc_slice_decoder_push(discmc_slice_decoder* decoder, const uint8_t* bytes,
                                         size_t count) {
  return c(cpp(decoder).push(bytes, count));
}
discmc_status discmc_slice_decoder_give_memory(discmc_slice_decoder* decoder,
                                               discmc_memory memory) {
  return c(cpp(decoder).give_memory(cpp(memory)));
}
discmc_status discmc_slice_decoder_finish(discmc_slice_decoder* decoder) {
  return c(cpp(decoder).finish());
}
discmc_stream_header discmc_slice_decoder_header(const discmc_slice_decoder* decoder) {
  return c(cpp(decoder).header());
}
discmc_stream_report discmc_slice_decoder_report(const discmc_slice_decoder* decoder) {
  return c(cpp(decoder).report());
}

uint64_t discmc_minimum_surface_bytes(const discmc_limits* limits, uint32_t surfaces) {
  return minimum_surface_bytes(cpp(*limits), surfaces);
}
discmc_status discmc_surface_decoder_start(discmc_surface_decoder* decoder, discmc_memory memory,
                                           const discmc_sink* sink, uint8_t channel) {
  return adapter(decoder).start_to(
      *sink, [&](const Sink& to) { return cpp(decoder).start(cpp(memory), to, channel); });
}
void discmc_surface_decoder_pass_whole_regions_to(discmc_surface_decoder* decoder,
                                                  const discmc_records_packet_sink* sink) {
  cpp(decoder).pass_whole_regions_to(cpp(sink));
}
discmc_decoded discmc_surface_decoder_push(discmc_surface_decoder* decoder, const uint8_t* bytes,
                                           size_t count) {
  return c(cpp(decoder).push(bytes, count));
}
discmc_status discmc_surface_decoder_give_memory(discmc_surface_decoder* decoder,
                                                 discmc_memory memory) {
  return c(cpp(decoder).give_memory(cpp(memory)));
}
discmc_status discmc_surface_decoder_finish(discmc_surface_decoder* decoder) {
  return c(cpp(decoder).finish());
}
discmc_stream_header discmc_surface_decoder_header(const discmc_surface_decoder* decoder) {
  return c(cpp(decoder).header());
}
discmc_stream_report discmc_surface_decoder_report(const discmc_surface_decoder* decoder) {
  return c(cpp(decoder).report());
}

}  // extern "C"

}  // namespace discmc
