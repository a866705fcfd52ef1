// discmc.h in terms of the C++ library.
//
// A C object is storage, and the C++ object lies in it. All of these classes are trivially copyable
// and zero as they begin, so storage of zeros is such an object, and nothing need be constructed.
// Records that pass often (events, runs, vertices) have the same layout on both sides and are
// looked at in place; the others are copied member by member.
#include <discmc/discmc.h>

#include <discmc/discmc.hpp>

using namespace discmc;

namespace {

template <class Object, class Storage>
constexpr bool fits = sizeof(Object) <= sizeof(Storage) &&
                      sizeof(Storage) - sizeof(Object) <= sizeof(Object) / 8 &&
                      alignof(Object) <= alignof(Storage) && __is_trivially_copyable(Object);

static_assert(fits<Extractor16, discmc_extractor16> && fits<Extractor32, discmc_extractor32> &&
                  fits<Encoder, discmc_encoder> && fits<Decoder, discmc_decoder>,
              "the sizes in discmc.h are enough and not much more");

#define DISCMC_SAME_PLACE(member) (offsetof(Event, member) == offsetof(discmc_event, member))
static_assert(sizeof(Event) == sizeof(discmc_event) && DISCMC_SAME_PLACE(kind) &&
                  DISCMC_SAME_PLACE(incidence) && DISCMC_SAME_PLACE(hole) &&
                  DISCMC_SAME_PLACE(repeated) && DISCMC_SAME_PLACE(abandoned) &&
                  DISCMC_SAME_PLACE(run) && DISCMC_SAME_PLACE(number) && DISCMC_SAME_PLACE(slice) &&
                  DISCMC_SAME_PLACE(row) && DISCMC_SAME_PLACE(start) &&
                  DISCMC_SAME_PLACE(statistics),
              "events have one layout");
#undef DISCMC_SAME_PLACE
static_assert(sizeof(Run) == sizeof(discmc_run) && sizeof(Vertex) == sizeof(discmc_vertex) &&
                  sizeof(Statistics) == sizeof(discmc_statistics),
              "so have runs, vertices and totals");

static_assert(DISCMC_WRONG_VERSION == static_cast<int>(Status::wrong_version) &&
                  DISCMC_TOO_DEEP == static_cast<int>(Status::too_deep) &&
                  DISCMC_FINISHED == static_cast<int>(Status::finished) &&
                  DISCMC_LOST == static_cast<int>(Event::Kind::lost) &&
                  DISCMC_NOT_NOW == static_cast<int>(Answer::not_now) &&
                  DISCMC_OPEN == static_cast<int>(Border::open) &&
                  DISCMC_PREVIOUS_ROW == static_cast<int>(Substitute::previous_row),
              "enumerations are in the same order");

constexpr bool minimum_agrees(uint32_t width, uint32_t height, Border border) {
  const uint32_t c = static_cast<uint32_t>(border);
  const Limits limits{width, height, border};
  return DISCMC_MINIMUM_BYTES16(width, height, c) == minimum_bytes<uint16_t>(limits) &&
         DISCMC_MINIMUM_BYTES32(width, height, c) == minimum_bytes<uint32_t>(limits);
}
static_assert(minimum_agrees(1, 1, Border::closed) && minimum_agrees(1, 1, Border::open) &&
                  minimum_agrees(30, 7, Border::closed) && minimum_agrees(31, 7, Border::closed) &&
                  minimum_agrees(32766, 32766, Border::closed),
              "the macros of discmc.h are minimum_bytes()");

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
discmc_vertex c(const Vertex& from) {
  return {from.x, from.y, from.z};
}
discmc_status c(Status status) {
  return static_cast<discmc_status>(status);
}
discmc_pushed c(Pushed pushed) {
  return {c(pushed.status), pushed.samples};
}

const Run* cpp(const discmc_run* runs) {
  return reinterpret_cast<const Run*>(runs);
}
Run* cpp(discmc_run* runs) {
  return reinterpret_cast<Run*>(runs);
}
Vertex* cpp(discmc_vertex* vertices) {
  return reinterpret_cast<Vertex*>(vertices);
}

// The C sink is the context, so it has to outlive the scan.
Sink cpp(const discmc_sink& sink) {
  if (sink.take == nullptr) return {};
  const auto take = [](void* context, const Event& event) {
    const discmc_sink& to = *static_cast<const discmc_sink*>(context);
    return static_cast<Answer>(to.take(to.context, reinterpret_cast<const discmc_event*>(&event)));
  };
  return {const_cast<discmc_sink*>(&sink), take, sink.takes_fragments != 0};
}

Extractor16& cpp(discmc_extractor16* extractor) {
  return *reinterpret_cast<Extractor16*>(extractor);
}
const Extractor16& cpp(const discmc_extractor16* extractor) {
  return *reinterpret_cast<const Extractor16*>(extractor);
}
Extractor32& cpp(discmc_extractor32* extractor) {
  return *reinterpret_cast<Extractor32*>(extractor);
}
const Extractor32& cpp(const discmc_extractor32* extractor) {
  return *reinterpret_cast<const Extractor32*>(extractor);
}
Encoder& cpp(discmc_encoder* encoder) {
  return *reinterpret_cast<Encoder*>(encoder);
}
const Encoder& cpp(const discmc_encoder* encoder) {
  return *reinterpret_cast<const Encoder*>(encoder);
}
Decoder& cpp(discmc_decoder* decoder) {
  return *reinterpret_cast<Decoder*>(decoder);
}
const Decoder& cpp(const discmc_decoder* decoder) {
  return *reinterpret_cast<const Decoder*>(decoder);
}

template <class Index>
Status start(Extractor<Index>& extractor, const discmc_limits& limits,
             const discmc_capacities* capacities, int32_t threshold, discmc_memory memory,
             const discmc_sink& sink) {
  const Memory bytes{memory.data, memory.bytes};
  if (capacities == nullptr) return extractor.start(cpp(limits), threshold, bytes, cpp(sink));
  return extractor.start(cpp(limits), cpp(*capacities), threshold, bytes, cpp(sink));
}

}  // namespace

const char* discmc_text(discmc_status status) {
  return text(static_cast<Status>(status));
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
    return c(start(cpp(extractor), *limits, capacities, threshold, memory, *sink));                \
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
uint64_t discmc_encoder_bytes(const discmc_encoder* encoder) {
  return cpp(encoder).bytes();
}

discmc_status discmc_decoder_start(discmc_decoder* decoder, const discmc_sink* sink) {
  return c(cpp(decoder).start(cpp(*sink)));
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

discmc_run discmc_run_straight(uint8_t direction, uint32_t length) {
  return Run::straight(direction, length).code();
}
uint8_t discmc_run_is_fragment(discmc_run run) {
  return Run::from_code(run).is_fragment() ? 1 : 0;
}
uint32_t discmc_run_fragment_number(discmc_run run) {
  return Run::from_code(run).fragment_number();
}
uint8_t discmc_run_direction(discmc_run run) {
  return Run::from_code(run).direction();
}
uint32_t discmc_run_length(discmc_run run) {
  return Run::from_code(run).length();
}

discmc_vertex discmc_normal(uint8_t incidence) {
  return c(normal(incidence));
}
uint8_t discmc_direction_count(uint8_t incidence) {
  return direction_count(incidence);
}
discmc_vertex discmc_direction_vector(uint8_t incidence, uint8_t direction) {
  return c(direction_vector(incidence, direction));
}
discmc_vertex discmc_displacement(uint8_t incidence, const discmc_run* runs, uint32_t count) {
  return c(displacement(incidence, cpp(runs), count));
}
void discmc_reverse(uint8_t incidence, discmc_run* runs, uint32_t count) {
  reverse(incidence, cpp(runs), count);
}
int64_t discmc_twice_area(uint8_t incidence, const discmc_run* runs, uint32_t count) {
  return twice_area(incidence, cpp(runs), count);
}
uint64_t discmc_link_count(const discmc_run* runs, uint32_t count) {
  return link_count(cpp(runs), count);
}

void discmc_unfold(uint8_t incidence, discmc_vertex start, const discmc_run* runs, uint32_t count,
                   discmc_vertex* vertices) {
  unfold(incidence, {start.x, start.y, start.z}, cpp(runs), count, cpp(vertices));
}
void discmc_split_ring(discmc_vertex* vertices, uint32_t count, uint32_t* scratch,
                       const discmc_ring_receiver* receiver) {
  const auto take = [](void* context, const Vertex* ring, uint32_t length) {
    const discmc_ring_receiver& to = *static_cast<const discmc_ring_receiver*>(context);
    to.take(to.context, reinterpret_cast<const discmc_vertex*>(ring), length);
  };
  split_ring(cpp(vertices), count, scratch, {const_cast<discmc_ring_receiver*>(receiver), take});
}
uint32_t discmc_keep_corners(discmc_vertex* vertices, uint32_t count,
                             uint8_t (*keep)(void* context, const discmc_vertex* vertex),
                             void* context) {
  return keep_corners(cpp(vertices), count, [=](const Vertex& vertex) {
    return keep != nullptr && keep(context, reinterpret_cast<const discmc_vertex*>(&vertex)) != 0;
  });
}
