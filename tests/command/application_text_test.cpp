// Application records in words.
#include "streams/application_text.hpp"

#include <discmc/placement.hpp>

#include "test.hpp"

using namespace discmc;
using command::text;

namespace {

std::string text_of(const Placement& placement) {
  uint8_t bytes[Placement::record_bytes];
  return text(record_of(placement, bytes));
}

}  // namespace

TEST_CASE("an application record is printed with its kind, position and bytes") {
  const uint8_t bytes[] = {0, 0x7F, 0xA0};
  CHECK(text(ApplicationRecord{3, 40, 5, bytes, 3}) == "kind 3, slice 40, row 5: 3 bytes 00 7f a0");
  CHECK(text(ApplicationRecord{0, 0, 0, bytes, 1}) == "kind 0, slice 0, row 0: 1 byte 00");
  CHECK(text(ApplicationRecord{9, 1, 2, nullptr, 0}) == "kind 9, slice 1, row 2: 0 bytes");
}

TEST_CASE("a placement record is printed in millimetres, exact to the nanometre") {
  Placement placement;
  placement.axes_nm[0][0] = -1500000;
  placement.axes_nm[1][1] = 1;
  placement.axes_nm[2][2] = 20000000;
  placement.origin_nm[0] = INT64_MIN;
  placement.origin_nm[1] = 100000000;
  placement.origin_nm[2] = -10;
  placement.space = Space::ras;
  CHECK(text_of(placement) ==
        "kind 240, slice 0, row 0: placement in RAS, mm: origin (-9223372036854.775808, 100, "
        "-0.00001), axes (-1.5, 0, 0) (0, 0.000001, 0) (0, 0, 20)");
  CHECK(text_of({}).find("placement in scanner space") != std::string::npos);
  placement.space = Space::lps;
  CHECK(text_of(placement).find("placement in LPS") != std::string::npos);
}

TEST_CASE("an invalid record of a placement's kind is printed as bytes") {
  const uint8_t bytes[] = {1};
  CHECK(text(ApplicationRecord{Placement::record_kind, 0, 0, bytes, 1}) ==
        "kind 240, slice 0, row 0: 1 byte 01");
}
