// The slices of a stream, as an application record.
#include <discmc/placement.hpp>
#include <iterator>

#include "test.hpp"

using namespace discmc;

namespace {

bool equal(const SlabRange& a, const SlabRange& b) {
  return a.first == b.first && a.slices == b.slices && a.depth == b.depth;
}

}  // namespace

TEST_CASE("the bytes of a slab range record are as documented") {
  const SlabRange range{0x01020304, 5, 0xFFFFFFFF};
  uint8_t bytes[SlabRange::record_bytes];
  const ApplicationRecord record = record_of(range, bytes);
  const uint8_t expected[] = {4, 3, 2, 1, 5, 0, 0, 0, 255, 255, 255, 255};
  CHECK(record.kind == 241);
  CHECK(record.slice == 0);
  CHECK(record.row == 0);
  CHECK(record.count == sizeof expected);
  CHECK(std::equal(std::begin(expected), std::end(expected), record.bytes));
  SlabRange read;
  CHECK(read_slab_range(record, read));
  CHECK(equal(read, range));
  CHECK(read.end() == 0x01020309);
  CHECK(equal(SlabRange{}, {0, 0, 0}));
}

TEST_CASE("an invalid range of slices is refused and not stored") {
  const SlabRange before{7, 8, 90};
  SlabRange read = before;
  const auto refuses = [&](const SlabRange& range, uint8_t kind = SlabRange::record_kind,
                           size_t count = SlabRange::record_bytes) {
    uint8_t bytes[SlabRange::record_bytes + 1] = {};
    record_of(range, bytes);
    return !read_slab_range({kind, 0, 0, bytes, count}, read) && equal(read, before);
  };
  CHECK(refuses({0, 0, 10}));
  CHECK(refuses({0, 11, 10}));
  CHECK(refuses({10, 1, 10}));
  CHECK(refuses({0xFFFFFFFF, 2, 10}));
  CHECK(refuses({0, 1, 10}, 240));
  CHECK(refuses({0, 1, 10}, 241, 11));
  CHECK(refuses({0, 1, 10}, 241, 13));
  CHECK_FALSE(refuses({9, 1, 10}));
}
