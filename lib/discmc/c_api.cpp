// discmc.h in terms of the C++ library: sizes, extractor, encoder and decoder.
//
// A C object is storage, and the C++ object lies in it; C never looks into it. The classes are
// trivially copyable, and zero as they begin (what is not, of a decoder, is set before it is read),
// so storage of zeros is such an object, and nothing need be constructed. Events and totals have
// one layout on both sides and are looked at in place, each side through its own type; what passes
// seldom is copied member by member.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/discmc.hpp>

using namespace discmc;

namespace {

#define DISCMC_SAME_PLACE(member) (offsetof(Event, member) == offsetof(discmc_event, member))
static_assert(sizeof(Event) == sizeof(discmc_event) && DISCMC_SAME_PLACE(kind) &&
                  DISCMC_SAME_PLACE(incidence) && DISCMC_SAME_PLACE(came) &&
                  DISCMC_SAME_PLACE(hole) && DISCMC_SAME_PLACE(repeated) &&
                  DISCMC_SAME_PLACE(abandoned) && DISCMC_SAME_PLACE(normal) &&
                  DISCMC_SAME_PLACE(run) && DISCMC_SAME_PLACE(number) && DISCMC_SAME_PLACE(slice) &&
                  DISCMC_SAME_PLACE(row) && DISCMC_SAME_PLACE(start) &&
                  DISCMC_SAME_PLACE(statistics),
              "events have one layout");
#undef DISCMC_SAME_PLACE
#define DISCMC_SAME_PLACE(member) \
  (offsetof(Statistics, member) == offsetof(discmc_statistics, member))
static_assert(sizeof(Statistics) == sizeof(discmc_statistics) && DISCMC_SAME_PLACE(cells) &&
                  DISCMC_SAME_PLACE(facets) && DISCMC_SAME_PLACE(classic_triangles) &&
                  DISCMC_SAME_PLACE(regions) && DISCMC_SAME_PLACE(rings) &&
                  DISCMC_SAME_PLACE(links) && DISCMC_SAME_PLACE(cuts) &&
                  DISCMC_SAME_PLACE(spills) && DISCMC_SAME_PLACE(skipped_rows),
              "so have totals");
#undef DISCMC_SAME_PLACE

static_assert(DISCMC_BAD_CHECKPOINT == static_cast<int>(Status::bad_checkpoint) &&
                  DISCMC_TOO_DEEP == static_cast<int>(Status::too_deep) &&
                  DISCMC_FINISHED == static_cast<int>(Status::finished) &&
                  DISCMC_LOST == static_cast<int>(Event::Kind::lost) &&
                  DISCMC_NOT_NOW == static_cast<int>(Answer::not_now) &&
                  DISCMC_OPEN == static_cast<int>(Border::open) &&
                  DISCMC_PREVIOUS_ROW == static_cast<int>(Substitute::previous_row),
              "enumerations are in the same order");

static_assert(Limits::max_extent == DISCMC_MAX_EXTENT && Limits::max_slices == DISCMC_MAX_SLICES &&
                  wire::version == DISCMC_WIRE_VERSION && wire::max_frame == DISCMC_MAX_FRAME,
              "constants are the same");

template <class Index, uint64_t i = sizeof(Index)>
constexpr bool sizes_agree =
    DISCMC_EDGE_BYTES_(i) == sizeof(Edge<Index>) &&
    DISCMC_RUN_BYTES_(i) == sizeof(RunNode<Index>) &&
    DISCMC_RING_BYTES_(i) == sizeof(ClosedRing<Index>) &&
    DISCMC_REGION_BYTES_(i) == sizeof(RegionNode<Index>) &&
    DISCMC_MINIMUM_BYTES_(i, 31, 7, DISCMC_OPEN) == minimum_bytes<Index>({31, 7, Border::open}) &&
    DISCMC_WORST_CASE_BYTES_(i, 31, 7, DISCMC_CLOSED) == worst_case_bytes<Index>({31, 7});
static_assert(sizes_agree<uint16_t> && sizes_agree<uint32_t>,
              "the constants of sizes.h are what the functions give; the tests have many more");

Limits cpp(const discmc_limits& limits) {
  return {limits.width, limits.height, static_cast<Border>(limits.border)};
}
Capacities cpp(const discmc_capacities& c) {
  return {c.edges, c.runs, c.rings, c.regions, c.slots};
}
discmc_capacities c(const Capacities& from) {
  return {from.edges, from.runs, from.rings, from.regions, from.slots};
}
discmc_statistics c(const Statistics& from) {
  return {from.cells, from.facets, from.classic_triangles, from.regions, from.rings, from.links,
          from.cuts,  from.spills, from.skipped_rows};
}
discmc_status c(Status status) {
  return static_cast<discmc_status>(status);
}
discmc_pushed c(Pushed pushed) {
  return {c(pushed.status), pushed.samples};
}

static_assert(fits<SinkAdapter<Extractor16>, discmc_extractor16> &&
                  fits<SinkAdapter<Extractor32>, discmc_extractor32> &&
                  fits<Encoder, discmc_encoder> && fits<SinkAdapter<Decoder>, discmc_decoder>,
              "the sizes in discmc.h are enough and not much more");
static_assert(fits<Checkpoint<Extractor16>, discmc_extractor16_checkpoint> &&
                  fits<Checkpoint<Extractor32>, discmc_extractor32_checkpoint> &&
                  fits<Checkpoint<Encoder>, discmc_encoder_checkpoint>,
              "so are those of checkpoints");

SinkAdapter<Extractor16>& adapter(discmc_extractor16* extractor) {
  return *reinterpret_cast<SinkAdapter<Extractor16>*>(extractor);
}
SinkAdapter<Extractor32>& adapter(discmc_extractor32* extractor) {
  return *reinterpret_cast<SinkAdapter<Extractor32>*>(extractor);
}
SinkAdapter<Decoder>& adapter(discmc_decoder* decoder) {
  return *reinterpret_cast<SinkAdapter<Decoder>*>(decoder);
}

Extractor16& cpp(discmc_extractor16* extractor) {
  return adapter(extractor).object;
}
const Extractor16& cpp(const discmc_extractor16* extractor) {
  return reinterpret_cast<const SinkAdapter<Extractor16>*>(extractor)->object;
}
Extractor32& cpp(discmc_extractor32* extractor) {
  return adapter(extractor).object;
}
const Extractor32& cpp(const discmc_extractor32* extractor) {
  return reinterpret_cast<const SinkAdapter<Extractor32>*>(extractor)->object;
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
  return reinterpret_cast<const SinkAdapter<Decoder>*>(decoder)->object;
}

}  // namespace

const char* discmc_text(discmc_status status) {
  return text(static_cast<Status>(status));
}

uint8_t discmc_limits_are_valid(const discmc_limits* limits) {
  return cpp(*limits).are_valid() ? 1 : 0;
}
uint8_t discmc_capacities_are_valid16(const discmc_capacities* capacities) {
  return are_valid<uint16_t>(cpp(*capacities)) ? 1 : 0;
}
uint8_t discmc_capacities_are_valid32(const discmc_capacities* capacities) {
  return are_valid<uint32_t>(cpp(*capacities)) ? 1 : 0;
}
uint64_t discmc_minimum_bytes16(const discmc_limits* limits) {
  return minimum_bytes<uint16_t>(cpp(*limits));
}
uint64_t discmc_minimum_bytes32(const discmc_limits* limits) {
  return minimum_bytes<uint32_t>(cpp(*limits));
}
uint64_t discmc_bytes_for16(const discmc_limits* limits, const discmc_capacities* capacities) {
  return bytes_for<uint16_t>(cpp(*limits), cpp(*capacities));
}
uint64_t discmc_bytes_for32(const discmc_limits* limits, const discmc_capacities* capacities) {
  return bytes_for<uint32_t>(cpp(*limits), cpp(*capacities));
}
uint64_t discmc_worst_case_bytes16(const discmc_limits* limits) {
  return worst_case_bytes<uint16_t>(cpp(*limits));
}
uint64_t discmc_worst_case_bytes32(const discmc_limits* limits) {
  return worst_case_bytes<uint32_t>(cpp(*limits));
}
discmc_capacities discmc_minimum_capacities(void) {
  return c(minimum_capacities());
}
discmc_capacities discmc_worst_case_capacities(const discmc_limits* limits) {
  return c(worst_case_capacities(cpp(*limits)));
}
discmc_capacities discmc_default_capacities16(const discmc_limits* limits, uint64_t bytes) {
  return c(default_capacities<uint16_t>(cpp(*limits), bytes));
}
discmc_capacities discmc_default_capacities32(const discmc_limits* limits, uint64_t bytes) {
  return c(default_capacities<uint32_t>(cpp(*limits), bytes));
}

// Both extractors have the same functions, which differ in nothing but the bits of an index.
#define DISCMC_EXTRACTOR(bits)                                                                     \
  discmc_status discmc_extractor##bits##_start(                                                    \
      discmc_extractor##bits* extractor, const discmc_limits* limits,                              \
      const discmc_capacities* capacities, int32_t threshold, discmc_memory memory,                \
      const discmc_sink* sink) {                                                                   \
    return adapter(extractor).start_to(*sink, [&](const Sink& to) {                                \
      const Memory bytes{memory.data, memory.bytes};                                               \
      return capacities == nullptr                                                                 \
                 ? cpp(extractor).start(cpp(*limits), threshold, bytes, to)                        \
                 : cpp(extractor).start(cpp(*limits), cpp(*capacities), threshold, bytes, to);     \
    });                                                                                            \
  }                                                                                                \
  discmc_status discmc_extractor##bits##_reset(discmc_extractor##bits* extractor) {                \
    return c(cpp(extractor).reset());                                                              \
  }                                                                                                \
  discmc_pushed discmc_extractor##bits##_push_u8(discmc_extractor##bits* extractor,                \
                                                 const uint8_t* samples, uint32_t count,           \
                                                 uint32_t stride) {                                \
    return c(cpp(extractor).push(samples, count, stride));                                         \
  }                                                                                                \
  discmc_pushed discmc_extractor##bits##_push_u16(discmc_extractor##bits* extractor,               \
                                                  const uint16_t* samples, uint32_t count,         \
                                                  uint32_t stride) {                               \
    return c(cpp(extractor).push(samples, count, stride));                                         \
  }                                                                                                \
  discmc_pushed discmc_extractor##bits##_push_i16(discmc_extractor##bits* extractor,               \
                                                  const int16_t* samples, uint32_t count,          \
                                                  uint32_t stride) {                               \
    return c(cpp(extractor).push(samples, count, stride));                                         \
  }                                                                                                \
  discmc_pushed discmc_extractor##bits##_push_bits(discmc_extractor##bits* extractor,              \
                                                   const uint8_t* packed) {                        \
    return c(cpp(extractor).push_bits(packed));                                                    \
  }                                                                                                \
  discmc_pushed discmc_extractor##bits##_skip_row(discmc_extractor##bits* extractor,               \
                                                  uint8_t substitute) {                            \
    return c(cpp(extractor).skip_row(static_cast<Substitute>(substitute)));                        \
  }                                                                                                \
  discmc_status discmc_extractor##bits##_resume(discmc_extractor##bits* extractor) {               \
    return c(cpp(extractor).resume());                                                             \
  }                                                                                                \
  discmc_status discmc_extractor##bits##_finish(discmc_extractor##bits* extractor) {               \
    return c(cpp(extractor).finish());                                                             \
  }                                                                                                \
  discmc_status discmc_extractor##bits##_abandon(discmc_extractor##bits* extractor) {              \
    return c(cpp(extractor).abandon());                                                            \
  }                                                                                                \
  discmc_status discmc_extractor##bits##_save(const discmc_extractor##bits* extractor,             \
                                              discmc_extractor##bits##_checkpoint* checkpoint) {   \
    return c(cpp(extractor).save(*reinterpret_cast<Checkpoint<Extractor##bits>*>(checkpoint)));    \
  }                                                                                                \
  discmc_status discmc_extractor##bits##_restore(                                                  \
      discmc_extractor##bits* extractor, const discmc_extractor##bits##_checkpoint* checkpoint,    \
      discmc_memory memory, const discmc_sink* sink) {                                             \
    return adapter(extractor).start_to(*sink, [&](const Sink& to) {                                \
      return cpp(extractor).restore(                                                               \
          *reinterpret_cast<const Checkpoint<Extractor##bits>*>(checkpoint),                       \
          {memory.data, memory.bytes}, to);                                                        \
    });                                                                                            \
  }                                                                                                \
  discmc_statistics discmc_extractor##bits##_statistics(const discmc_extractor##bits* extractor) { \
    return c(cpp(extractor).statistics());                                                         \
  }                                                                                                \
  discmc_limits discmc_extractor##bits##_limits(const discmc_extractor##bits* extractor) {         \
    const Limits& limits = cpp(extractor).limits();                                                \
    return {limits.width, limits.height, static_cast<uint8_t>(limits.border)};                     \
  }                                                                                                \
  discmc_capacities discmc_extractor##bits##_capacities(const discmc_extractor##bits* extractor) { \
    return c(cpp(extractor).capacities());                                                         \
  }                                                                                                \
  discmc_high_water discmc_extractor##bits##_high_water(const discmc_extractor##bits* extractor) { \
    const HighWater most = cpp(extractor).high_water();                                            \
    return {most.edges, most.runs, most.rings, most.regions, most.slots};                          \
  }                                                                                                \
  size_t discmc_extractor##bits##_bytes_used(const discmc_extractor##bits* extractor) {            \
    return cpp(extractor).bytes_used();                                                            \
  }                                                                                                \
  uint32_t discmc_extractor##bits##_slices(const discmc_extractor##bits* extractor) {              \
    return cpp(extractor).slices();                                                                \
  }                                                                                                \
  uint32_t discmc_extractor##bits##_rows(const discmc_extractor##bits* extractor) {                \
    return cpp(extractor).rows();                                                                  \
  }

DISCMC_EXTRACTOR(16)
DISCMC_EXTRACTOR(32)
#undef DISCMC_EXTRACTOR

discmc_status discmc_encoder_start(discmc_encoder* encoder, const discmc_stream_header* header,
                                   discmc_byte_output output) {
  const StreamHeader told{
      header->width,     header->height,
      header->depth,     {header->spacing_nm[0], header->spacing_nm[1], header->spacing_nm[2]},
      header->threshold, static_cast<Border>(header->border)};
  return c(cpp(encoder).start(told, {output.context, output.write}));
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
  return c(cpp(encoder).restore(*reinterpret_cast<const Checkpoint<Encoder>*>(checkpoint),
                                {output.context, output.write}));
}
uint64_t discmc_encoder_bytes(const discmc_encoder* encoder) {
  return cpp(encoder).bytes();
}

discmc_status discmc_decoder_start(discmc_decoder* decoder, const discmc_sink* sink) {
  return adapter(decoder).start_to(*sink, [&](const Sink& to) { return cpp(decoder).start(to); });
}
discmc_decoded discmc_decoder_push(discmc_decoder* decoder, const uint8_t* bytes, size_t count) {
  const Decoded decoded = cpp(decoder).push(bytes, count);
  return {c(decoded.status), decoded.bytes};
}
discmc_status discmc_decoder_finish(discmc_decoder* decoder) {
  return c(cpp(decoder).finish());
}
discmc_stream_header discmc_decoder_header(const discmc_decoder* decoder) {
  const StreamHeader& from = cpp(decoder).header();
  return {from.width,     from.height,
          from.depth,     {from.spacing_nm[0], from.spacing_nm[1], from.spacing_nm[2]},
          from.threshold, static_cast<uint8_t>(from.border)};
}
discmc_stream_report discmc_decoder_report(const discmc_decoder* decoder) {
  const StreamReport& from = cpp(decoder).report();
  return {from.has_header,      from.has_trailer,  from.abandoned, from.is_unreadable,
          from.is_complete(),   from.bytes,        from.packets,   from.repeated_packets,
          from.damaged_packets, from.lost_packets, from.regions,   from.lost_regions,
          from.slices,          c(from.totals)};
}
