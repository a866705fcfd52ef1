// What the files of the C API share: values of C's as those of C++, and the other way round.
// Headers and application records have one layout on both sides, which c_api.cpp checks.
#ifndef DISCMC_C_VALUES_HPP
#define DISCMC_C_VALUES_HPP

#include <discmc/discmc.h>
#include <discmc/arena.hpp>
#include <discmc/decoder.hpp>
#include <discmc/row_input.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc {

inline Limits cpp(const discmc_limits& from) {
  return {from.width,
          from.height,
          static_cast<Border>(from.border),
          {from.slab.first, from.slab.continues_below != 0, from.slab.continues_above != 0}};
}
inline Memory cpp(const discmc_memory& from) {
  return {from.data, from.bytes};
}
inline ByteOutput cpp(const discmc_byte_output& from) {
  return {from.context, from.write};
}
inline const StreamHeader& cpp(const discmc_stream_header& from) {
  return reinterpret_cast<const StreamHeader&>(from);
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
inline discmc_decoded c(Decoded from) {
  return {c(from.status), from.bytes};
}
inline discmc_statistics c(const Statistics& from) {
  return {from.cells, from.facets, from.classic_triangles, from.regions,
          from.rings, from.links,  from.fragments,         from.skipped_rows};
}
inline discmc_stream_header c(const StreamHeader& from) {
  return *reinterpret_cast<const discmc_stream_header*>(&from);
}
inline discmc_application_record c(const ApplicationRecord& from) {
  return *reinterpret_cast<const discmc_application_record*>(&from);
}
inline discmc_stream_report c(const StreamReport& from) {
  return {from.has_header,    from.holds_slices,     from.has_trailer,     from.abandoned,
          from.is_unreadable, from.is_mixed,         from.is_complete(),   from.bytes,
          from.packets,       from.repeated_packets, from.damaged_packets, from.foreign_packets,
          from.lost_packets,  from.regions,          from.fragments,       from.lost_pieces,
          from.rows,          from.lost_rows,        from.total_rows,      from.slices,
          c(from.totals)};
}

}  // namespace discmc

#endif
