// discmc.h in terms of the C++ library: sizes, extractor, encoder and decoder.
//
// A C object is storage, and the C++ object lies in it; C never looks into it. The classes are
// trivially copyable, and storage of zeros is an object that has not been started: start() or
// restore() sets whatever else is read. So nothing need be constructed. Events and totals have one
// layout on both sides and are read in place, each side through its own type; what is rarely passed
// is copied member by member.
#include <discmc/discmc.h>

#include <discmc/c_extractors.hpp>
#include <discmc/encoder.hpp>
#include <discmc/version.hpp>

namespace discmc {

namespace {

#define DISCMC_SAME_PLACE(member) (offsetof(Event, member) == offsetof(discmc_event, member))
static_assert(sizeof(Event) == sizeof(discmc_event) && DISCMC_SAME_PLACE(kind) &&
                  DISCMC_SAME_PLACE(incidence) && DISCMC_SAME_PLACE(came) &&
                  DISCMC_SAME_PLACE(hole) && DISCMC_SAME_PLACE(repeated) &&
                  DISCMC_SAME_PLACE(abandoned) && DISCMC_SAME_PLACE(normal) &&
                  DISCMC_SAME_PLACE(run) && DISCMC_SAME_PLACE(slice) && DISCMC_SAME_PLACE(row) &&
                  DISCMC_SAME_PLACE(start) &&
                  offsetof(Event, statistics) == offsetof(discmc_event, of),
              "events have one layout");
#undef DISCMC_SAME_PLACE
#define DISCMC_SAME_PLACE(member) \
  (offsetof(StreamHeader, member) == offsetof(discmc_stream_header, member))
static_assert(sizeof(StreamHeader) == sizeof(discmc_stream_header) && DISCMC_SAME_PLACE(width) &&
                  DISCMC_SAME_PLACE(height) && DISCMC_SAME_PLACE(depth) &&
                  DISCMC_SAME_PLACE(spacing_nm) && DISCMC_SAME_PLACE(threshold) &&
                  DISCMC_SAME_PLACE(border) && DISCMC_SAME_PLACE(channel) &&
                  DISCMC_SAME_PLACE(scan) && DISCMC_SAME_PLACE(further_surfaces) &&
                  DISCMC_SAME_PLACE(further_thresholds),
              "so have headers");
#undef DISCMC_SAME_PLACE
#define DISCMC_SAME_PLACE(member) \
  (offsetof(ApplicationRecord, member) == offsetof(discmc_application_record, member))
static_assert(sizeof(ApplicationRecord) == sizeof(discmc_application_record) &&
                  DISCMC_SAME_PLACE(kind) && DISCMC_SAME_PLACE(slice) && DISCMC_SAME_PLACE(row) &&
                  DISCMC_SAME_PLACE(bytes) && DISCMC_SAME_PLACE(count),
              "so have application records");
#undef DISCMC_SAME_PLACE
#define DISCMC_SAME_PLACE(member) \
  (offsetof(RecordsPacket, member) == offsetof(discmc_records_packet, member))
static_assert(sizeof(RecordsPacket) == sizeof(discmc_records_packet) &&
                  DISCMC_SAME_PLACE(payload) && DISCMC_SAME_PLACE(bytes) &&
                  DISCMC_SAME_PLACE(pieces) && DISCMC_SAME_PLACE(is_whole),
              "so have packets of records");
#undef DISCMC_SAME_PLACE
#define DISCMC_SAME_PLACE(member) \
  (offsetof(Statistics, member) == offsetof(discmc_statistics, member))
static_assert(sizeof(Statistics) == sizeof(discmc_statistics) && DISCMC_SAME_PLACE(cells) &&
                  DISCMC_SAME_PLACE(facets) && DISCMC_SAME_PLACE(classic_triangles) &&
                  DISCMC_SAME_PLACE(regions) && DISCMC_SAME_PLACE(rings) &&
                  DISCMC_SAME_PLACE(links) && DISCMC_SAME_PLACE(fragments) &&
                  DISCMC_SAME_PLACE(skipped_rows),
              "so have totals");
#undef DISCMC_SAME_PLACE

static_assert(DISCMC_DEVICE_ERROR == static_cast<int>(Status::device_error) &&
                  DISCMC_TOO_DEEP == static_cast<int>(Status::too_deep) &&
                  DISCMC_FINISHED == static_cast<int>(Status::finished) &&
                  DISCMC_LOST == static_cast<int>(Event::Kind::lost) &&
                  DISCMC_NEVER == static_cast<int>(Answer::never) &&
                  DISCMC_OPEN == static_cast<int>(Border::open) &&
                  DISCMC_PREVIOUS_ROW == static_cast<int>(Substitute::previous_row),
              "enumerations are in the same order");

static_assert(Limits::max_extent == DISCMC_MAX_EXTENT && Limits::max_slices == DISCMC_MAX_SLICES &&
                  wire::version == DISCMC_WIRE_VERSION && wire::max_frame == DISCMC_MAX_FRAME &&
                  StreamLabel::max_channel == DISCMC_MAX_CHANNEL &&
                  StreamHeader::max_surfaces == DISCMC_MAX_SURFACES &&
                  any_channel == DISCMC_ANY_CHANNEL &&
                  wire::max_whole_regions == DISCMC_MAX_APPENDED &&
                  ApplicationRecord::max_bytes == DISCMC_MAX_RECORD_BYTES &&
                  ApplicationRecord::first_standard_kind == DISCMC_FIRST_STANDARD_KIND,
              "constants are the same");

static_assert(DISCMC_RECORD_BYTES_ == sizing::record_bytes<uint16_t, NoNormals> &&
                  DISCMC_MINIMUM_RECORDS_ == minimum_capacities().records &&
                  is_valid<uint16_t>({DISCMC_MOST_RECORDS_, 0}) &&
                  !is_valid<uint16_t>({DISCMC_MOST_RECORDS_ + 1, 0}) &&
                  DISCMC_MINIMUM_BYTES(31, 7) == minimum_bytes<uint16_t>({31, 7}) &&
                  DISCMC_DEFAULT_RECORDS_(31, 7, 5000) ==
                      default_capacities<uint16_t>({31, 7}, 5000).records,
              "the constants of sizes.h are what the functions give; the tests have many more");

using ExtractorAdapter = SinkAdapter<Extractor16>;
using DecoderAdapter = SinkAdapter<Decoder>;

static_assert(fits<ExtractorAdapter, discmc_extractor> && fits<Encoder, discmc_encoder> &&
                  fits<DecoderAdapter, discmc_decoder>,
              "the sizes in discmc.h are enough and not much more");
static_assert(fits<Checkpoint<Extractor16>, discmc_extractor_checkpoint> &&
                  fits<Checkpoint<Encoder>, discmc_encoder_checkpoint>,
              "so are those of checkpoints");

ExtractorAdapter& adapter(discmc_extractor* extractor) {
  return *reinterpret_cast<ExtractorAdapter*>(extractor);
}
DecoderAdapter& adapter(discmc_decoder* decoder) {
  return *reinterpret_cast<DecoderAdapter*>(decoder);
}

Extractor16& cpp(discmc_extractor* extractor) {
  return adapter(extractor).object;
}
const Extractor16& cpp(const discmc_extractor* extractor) {
  return reinterpret_cast<const ExtractorAdapter*>(extractor)->object;
}
Encoder& cpp(discmc_encoder* encoder) {
  return *reinterpret_cast<Encoder*>(encoder);
}
const Encoder& cpp(const discmc_encoder* encoder) {
  return *reinterpret_cast<const Encoder*>(encoder);
}
Decoder& cpp(discmc_decoder* decoder) {
  return adapter(decoder).object;
}
const Decoder& cpp(const discmc_decoder* decoder) {
  return reinterpret_cast<const DecoderAdapter*>(decoder)->object;
}

}  // namespace

extern "C" {

const char* discmc_text(discmc_status status) {
  return text(static_cast<Status>(status));
}

const char* discmc_version() {
  return version();
}

uint8_t discmc_limits_is_valid(const discmc_limits* limits) {
  return cpp(*limits).is_valid() ? 1 : 0;
}
uint8_t discmc_capacities_is_valid(const discmc_capacities* capacities) {
  return is_valid<uint16_t>(cpp(*capacities)) ? 1 : 0;
}
uint64_t discmc_minimum_bytes(const discmc_limits* limits) {
  return minimum_bytes<uint16_t>(cpp(*limits));
}
discmc_capacities discmc_minimum_capacities(void) {
  return c(minimum_capacities());
}
uint64_t discmc_bytes_for(const discmc_limits* limits, const discmc_capacities* capacities) {
  return bytes_for<uint16_t>(cpp(*limits), cpp(*capacities));
}
discmc_capacities discmc_default_capacities(const discmc_limits* limits, uint64_t bytes) {
  return c(default_capacities<uint16_t>(cpp(*limits), bytes));
}

discmc_capacities discmc_worst_case_capacities(const discmc_limits* limits, uint32_t slices) {
  return c(worst_case_capacities(cpp(*limits), slices));
}
uint8_t discmc_stream_header_is_valid(const discmc_stream_header* header) {
  return cpp(*header).is_valid() ? 1 : 0;
}

discmc_status discmc_extractor_start(discmc_extractor* extractor, const discmc_limits* limits,
                                     const discmc_capacities* capacities, int32_t threshold,
                                     discmc_memory memory, const discmc_sink* sink) {
  return start(adapter(extractor), limits, capacities, threshold, memory, sink);
}
discmc_status discmc_extractor_reset(discmc_extractor* extractor) {
  return c(cpp(extractor).reset());
}
discmc_push_result discmc_extractor_push_u8(discmc_extractor* extractor, const uint8_t* samples,
                                            uint32_t count, uint32_t stride) {
  return c(cpp(extractor).push(samples, count, stride));
}
discmc_push_result discmc_extractor_push_u16(discmc_extractor* extractor, const uint16_t* samples,
                                             uint32_t count, uint32_t stride) {
  return c(cpp(extractor).push(samples, count, stride));
}
discmc_push_result discmc_extractor_push_i16(discmc_extractor* extractor, const int16_t* samples,
                                             uint32_t count, uint32_t stride) {
  return c(cpp(extractor).push(samples, count, stride));
}
discmc_push_result discmc_extractor_push_bits(discmc_extractor* extractor, const uint8_t* bits) {
  return c(cpp(extractor).push_bits(bits));
}
discmc_push_result discmc_extractor_skip_row(discmc_extractor* extractor, uint8_t substitute) {
  return c(cpp(extractor).skip_row(static_cast<Substitute>(substitute)));
}
discmc_status discmc_extractor_resume(discmc_extractor* extractor) {
  return c(cpp(extractor).resume());
}
discmc_status discmc_extractor_finish(discmc_extractor* extractor) {
  return c(cpp(extractor).finish());
}
discmc_status discmc_extractor_abandon(discmc_extractor* extractor) {
  return c(cpp(extractor).abandon());
}
discmc_status discmc_extractor_save(const discmc_extractor* extractor,
                                    discmc_extractor_checkpoint* checkpoint) {
  return save(cpp(extractor), checkpoint);
}
discmc_status discmc_extractor_restore(discmc_extractor* extractor,
                                       const discmc_extractor_checkpoint* checkpoint,
                                       discmc_memory memory, const discmc_sink* sink) {
  return restore(adapter(extractor), checkpoint, memory, sink);
}
discmc_statistics discmc_extractor_statistics(const discmc_extractor* extractor) {
  return c(cpp(extractor).statistics());
}
discmc_limits discmc_extractor_limits(const discmc_extractor* extractor) {
  return c(cpp(extractor).limits());
}
discmc_capacities discmc_extractor_capacities(const discmc_extractor* extractor) {
  return c(cpp(extractor).capacities());
}
discmc_high_water discmc_extractor_high_water(const discmc_extractor* extractor) {
  return c(cpp(extractor).high_water());
}
size_t discmc_extractor_bytes_used(const discmc_extractor* extractor) {
  return cpp(extractor).bytes_used();
}
uint32_t discmc_extractor_slices(const discmc_extractor* extractor) {
  return cpp(extractor).slices();
}
uint32_t discmc_extractor_rows(const discmc_extractor* extractor) {
  return cpp(extractor).rows();
}

discmc_status discmc_encoder_start(discmc_encoder* encoder, const discmc_stream_label* label,
                                   discmc_byte_output output) {
  return c(cpp(encoder).start(cpp(*label), cpp(output)));
}
discmc_status discmc_encoder_tell(discmc_encoder* encoder,
                                  const discmc_application_record* record) {
  return c(cpp(encoder).tell(cpp(*record)));
}
discmc_status discmc_encoder_append(discmc_encoder* encoder, const discmc_records_packet* packet) {
  return c(cpp(encoder).append(cpp(*packet)));
}
void discmc_encoder_set_output(discmc_encoder* encoder, discmc_byte_output output) {
  cpp(encoder).set_output(cpp(output));
}
discmc_answer discmc_encoder_take(void* encoder, const discmc_event* event) {
  return static_cast<discmc_answer>(
      cpp(static_cast<discmc_encoder*>(encoder)).take(*reinterpret_cast<const Event*>(event)));
}
uint8_t discmc_encoder_flush(discmc_encoder* encoder) {
  return cpp(encoder).flush() ? 1 : 0;
}
discmc_status discmc_encoder_save(const discmc_encoder* encoder,
                                  discmc_encoder_checkpoint* checkpoint) {
  return c(cpp(encoder).save(*reinterpret_cast<Checkpoint<Encoder>*>(checkpoint)));
}
discmc_status discmc_encoder_restore(discmc_encoder* encoder,
                                     const discmc_encoder_checkpoint* checkpoint,
                                     discmc_byte_output output) {
  return c(
      cpp(encoder).restore(*reinterpret_cast<const Checkpoint<Encoder>*>(checkpoint), cpp(output)));
}
uint64_t discmc_encoder_bytes(const discmc_encoder* encoder) {
  return cpp(encoder).bytes();
}

discmc_status discmc_decoder_start(discmc_decoder* decoder, const discmc_sink* sink,
                                   uint8_t channel) {
  return adapter(decoder).start_to(*sink,
                                   [&](const Sink& to) { return cpp(decoder).start(to, channel); });
}
void discmc_decoder_pass_whole_regions_to(discmc_decoder* decoder,
                                          const discmc_records_packet_sink* sink) {
  cpp(decoder).pass_whole_regions_to(cpp(sink));
}
discmc_decoded discmc_decoder_push(discmc_decoder* decoder, const uint8_t* bytes, size_t count) {
  return c(cpp(decoder).push(bytes, count));
}
discmc_status discmc_decoder_finish(discmc_decoder* decoder) {
  return c(cpp(decoder).finish());
}
discmc_stream_header discmc_decoder_header(const discmc_decoder* decoder) {
  return c(cpp(decoder).header());
}
discmc_stream_report discmc_decoder_report(const discmc_decoder* decoder) {
  return c(cpp(decoder).report());
}

}  // extern "C"

}  // namespace discmc
