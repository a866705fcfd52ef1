// Converts values and sinks of C to C++. Events, totals, application records and the headers in
// events have the same layout in both languages, which c_events.cpp checks.
#ifndef DISCMC_C_VALUES_HPP
#define DISCMC_C_VALUES_HPP

#include <discmc/discmc.h>
#include <discmc/byte_output.hpp>
#include <discmc/memory.hpp>
#include <discmc/row_input.hpp>
#include <discmc/sink.hpp>

namespace discmc {

inline Memory cpp(const discmc_memory& from) {
  return {from.data, from.bytes};
}
inline Limits cpp(const discmc_limits& from) {
  return {from.width, from.height, static_cast<Border>(from.border)};
}
inline ByteOutput cpp(const discmc_byte_output& from) {
  return {from.context, from.write, from.unsent, from.max_frame};
}
inline StreamLabel cpp(const discmc_stream_label& from) {
  const int32_t(&spacing)[3] = from.spacing_nm;
  return {from.depth, {spacing[0], spacing[1], spacing[2]}, from.scan, from.channel};
}
inline const ApplicationRecord& cpp(const discmc_application_record& from) {
  return reinterpret_cast<const ApplicationRecord&>(from);
}

inline discmc_status c(Status status) {
  return static_cast<discmc_status>(status);
}
inline discmc_push_result c(PushResult from) {
  return {c(from.status), from.samples};
}
inline discmc_statistics c(const Statistics& from) {
  return {from.cells, from.facets, from.classic_triangles, from.regions,
          from.rings, from.links,  from.fragments,         from.skipped_rows};
}
inline discmc_vertex c(const Vertex& from) {
  return {from.x, from.y, from.z};
}

/// An object, and the C sink that receives its events.
template <class Object>
struct WithSink {
  Object object;
  discmc_sink sink;

  /// Sets the sink to `to`. A C++ function calls the C function.
  Sink set_sink(const discmc_sink& to) {
    sink = to;
    return {this, to.accept == nullptr ? nullptr : offer};
  }
  static SinkResult offer(void* context, const Event& event) {
    const discmc_sink& to = static_cast<const WithSink*>(context)->sink;
    return static_cast<SinkResult>(
        to.accept(to.context, reinterpret_cast<const discmc_event*>(&event)));
  }
};

/// Represents a row of bits in place of a sample type. Bits are one whole row, so their count is
/// the width.
struct Bits {};
template <class Sample>
constexpr discmc_sample_type type_of = sizeof(Sample) == 2
                                           ? (static_cast<Sample>(-1) < 0 ? DISCMC_I16 : DISCMC_U16)
                                           : DISCMC_U8;
template <>
inline constexpr discmc_sample_type type_of<Bits> = DISCMC_BITS;

template <class Sample, class Object>
discmc_push_result push_as(Object& object, const void* samples, uint32_t count, uint32_t stride) {
  if constexpr (type_of<Sample> == DISCMC_BITS) {
    if (count != object.limits().width) return {DISCMC_BAD_SAMPLES, 0};
    return c(object.push_bits(static_cast<const uint8_t*>(samples)));
  } else {
    return c(object.push(static_cast<const Sample*>(samples), count, stride));
  }
}

}  // namespace discmc

#endif
