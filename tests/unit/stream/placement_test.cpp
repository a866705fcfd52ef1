// The placement of a volume in space, as an application record.
#include <discmc/placement.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;

namespace {

using Bytes = std::vector<uint8_t>;

// All members differ, and some are at their limits.
Placement any_placement(Space space) {
  Placement placement;
  int32_t next = 0x01020304;
  for (auto& axis : placement.axes_nm)
    for (int32_t& along : axis) along = next++;
  placement.axes_nm[0][1] = INT32_MIN;
  placement.axes_nm[2][2] = INT32_MAX;
  placement.origin_nm[0] = -2;
  placement.origin_nm[1] = INT64_MIN;
  placement.origin_nm[2] = 0x0102030405060708;
  placement.space = space;
  return placement;
}

bool equal(const Placement& a, const Placement& b) {
  return std::equal(&a.axes_nm[0][0], &a.axes_nm[0][0] + 9, &b.axes_nm[0][0]) &&
         std::equal(a.origin_nm, a.origin_nm + 3, b.origin_nm) && a.space == b.space;
}

struct RecordBytes {
  explicit RecordBytes(const Placement& placement) : record(record_of(placement, bytes)) {}
  uint8_t bytes[Placement::record_bytes];
  ApplicationRecord record;
};

struct PlacementReceiver {
  Placement placement;
  uint32_t records = 0;

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::application && read_placement(*event.application, placement))
      ++records;
    return SinkResult::accepted;
  }
};

}  // namespace

TEST_CASE("a placement is read back unchanged from its record") {
  for (const Space space : {Space::scanner, Space::lps, Space::ras}) {
    const RecordBytes written(any_placement(space));
    Placement read;
    CHECK(read_placement(written.record, read));
    CHECK(equal(read, any_placement(space)));
  }
}

TEST_CASE("the bytes of a placement record are as documented") {
  Placement placement;
  placement.axes_nm[0][0] = -1;
  placement.axes_nm[0][1] = 0x01020304;
  placement.axes_nm[1][0] = 5;
  placement.origin_nm[2] = -256;
  placement.space = Space::ras;
  Bytes bytes(62, 0xA5);
  const ApplicationRecord record = record_of(placement, bytes.data());
  Bytes expected(62);
  std::fill_n(expected.begin(), 4, uint8_t{0xFF});
  expected[4] = 4;
  expected[5] = 3;
  expected[6] = 2;
  expected[7] = 1;
  expected[12] = 5;
  std::fill_n(expected.begin() + 53, 7, uint8_t{0xFF});
  expected[60] = 2;
  expected[61] = 0xA5;  // no placement is written after them
  CHECK(record.kind == 240);
  CHECK(record.slice == 0);
  CHECK(record.row == 0);
  CHECK(record.bytes == bytes.data());
  CHECK(record.count == 61);
  CHECK(bytes == expected);
}

TEST_CASE("a record of another kind, size or space is rejected as a placement") {
  const RecordBytes written(any_placement(Space::lps));
  const Placement before = any_placement(Space::ras);
  Placement read = before;
  const auto refuses = [&](const ApplicationRecord& record) {
    return !read_placement(record, read) && equal(read, before);
  };
  ApplicationRecord record = written.record;
  record.kind = 241;
  CHECK(refuses(record));
  Bytes longer(written.bytes, written.bytes + Placement::record_bytes);
  longer.push_back(0);
  for (const size_t count : {size_t{0}, Placement::record_bytes - 1, Placement::record_bytes + 1})
    CHECK(refuses({Placement::record_kind, 0, 0, longer.data(), count}));
  for (const uint8_t space : {uint8_t{3}, uint8_t{255}}) {
    longer[60] = space;
    CHECK(refuses({Placement::record_kind, 0, 0, longer.data(), Placement::record_bytes}));
  }
}

TEST_CASE("a placement is received unchanged from a stream") {
  test::Line line;
  Encoder encoder;
  reference::require_ok(test::begin_stream(encoder, test::any_header(), line.output()));
  const RecordBytes written(any_placement(Space::lps));
  reference::require_ok(encoder.write_record(written.record));
  PlacementReceiver receiver;
  Decoder decoder;
  reference::require_ok(decoder.start(make_sink(receiver)));
  reference::require_ok(decoder.push(line.bytes.data(), line.bytes.size()).status);
  CHECK(receiver.records == 1);
  CHECK(equal(receiver.placement, any_placement(Space::lps)));
}
