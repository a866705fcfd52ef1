// What the files of the C API share: values of C's as those of C++, and the other way round.
// Headers, application records and packets of records have one layout on both sides, which
// c_api.cpp checks.
#ifndef DISCMC_C_VALUES_HPP
#define DISCMC_C_VALUES_HPP

#include <discmc/discmc.h>
#include <discmc/arena.hpp>
#include <discmc/decoder.hpp>
#include <discmc/records_packet.hpp>
#include <discmc/row_input.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc {

inline Limits cpp(const discmc_limits& from) {
  return {from.width,
          from.height,
          static_cast<Border>(from.border),
          {from.slab.first, from.slab.continues_below != 0, from.slab.continues_above != 0}};
}
inline Vertex cpp(const discmc_vertex& from) {
  return {from.x, from.y, from.z};
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

inline const RecordsPacket& cpp(const discmc_records_packet& from) {
  return reinterpret_cast<const RecordsPacket&>(from);
}
inline StreamLabel cpp(const discmc_stream_label& from) {
  return {from.depth,
          {from.spacing_nm[0], from.spacing_nm[1], from.spacing_nm[2]},
          from.scan,
          from.channel};
}
/// sink: null for none; Owner: the caller, as long as packets are passed on.
inline RecordsPacketSink cpp(const discmc_records_packet_sink* sink) {
  if (sink == nullptr) return {};
  return {const_cast<discmc_records_packet_sink*>(sink),
          [](void* context, const RecordsPacket& packet) {
            const auto& to = *static_cast<const discmc_records_packet_sink*>(context);
            to.take(to.context, reinterpret_cast<const discmc_records_packet*>(&packet));
          }};
}

inline discmc_limits c(const Limits& from) {
  return {from.width,
          from.height,
          static_cast<uint8_t>(from.border),
          {from.slab.first, from.slab.continues_below, from.slab.continues_above}};
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
inline discmc_byte_output c(const ByteOutput& from) {
  return {from.context, from.write};
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
