#include <discmc/placement.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

ApplicationRecord record_of(const SlabRange& range, uint8_t* bytes) {
  uint8_t* end = detail::wire::put(bytes, range.first, 4);
  end = detail::wire::put(end, range.slices, 4);
  detail::wire::put(end, range.depth, 4);
  return {SlabRange::record_kind, 0, 0, bytes, SlabRange::record_bytes};
}

bool read_slab_range(const ApplicationRecord& record, SlabRange& range) {
  if (record.kind != SlabRange::record_kind || record.count != SlabRange::record_bytes)
    return false;
  detail::wire::ByteReader reader(record.bytes, record.count);
  const auto next = [&reader] { return static_cast<uint32_t>(reader.get(4)); };
  SlabRange read;
  read.first = next();
  read.slices = next();
  read.depth = next();
  if (read.slices == 0 || uint64_t{read.first} + read.slices > read.depth) return false;
  range = read;
  return true;
}

}  // namespace discmc
