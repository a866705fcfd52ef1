#include <discmc/placement.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

static_assert(Placement::record_bytes <= ApplicationRecord::max_bytes, "a record holds it");

ApplicationRecord record_of(const Placement& placement, uint8_t* bytes) {
  uint8_t* end = bytes;
  for (const auto& axis : placement.axes_nm)
    for (const int32_t along : axis) end = detail::wire::put(end, static_cast<uint32_t>(along), 4);
  for (const int64_t along : placement.origin_nm)
    end = detail::wire::put_long(end, static_cast<uint64_t>(along));
  detail::wire::put(end, static_cast<uint8_t>(placement.space), 1);
  return {Placement::record_kind, 0, 0, bytes, Placement::record_bytes};
}

bool read_placement(const ApplicationRecord& record, Placement& placement) {
  if (record.kind != Placement::record_kind || record.count != Placement::record_bytes)
    return false;
  detail::wire::ByteReader reader(record.bytes, record.count);
  Placement read;
  for (auto& axis : read.axes_nm)
    for (int32_t& along : axis) along = static_cast<int32_t>(static_cast<uint32_t>(reader.get(4)));
  for (int64_t& along : read.origin_nm) along = static_cast<int64_t>(reader.get(8));
  const uint64_t space = reader.get(1);
  if (space > static_cast<uint64_t>(Space::ras)) return false;
  read.space = static_cast<Space>(space);
  placement = read;
  return true;
}

}  // namespace discmc
