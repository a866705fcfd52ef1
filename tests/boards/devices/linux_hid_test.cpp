// Rows in HID reports: a complete row is accepted, lost reports cost only their rows, and repeated
// reports cost nothing.
#include <hid/row_assembler.hpp>
#include <hid/stream_reports.hpp>

#include "linux_scan.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::device;
using namespace discmc::test;

namespace {

using Kind = Report::Kind;

Bytes report_of(Kind kind, std::uint32_t number, std::uint16_t chunk = 0,
                const Bytes& payload = {}) {
  Bytes bytes(Report::bytes, 0xCC);
  Report{kind, static_cast<std::uint8_t>(payload.size()), chunk, number, payload.data()}.write(
      bytes.data());
  return bytes;
}

// The reports of all rows, as sent by a scanner.
std::vector<Bytes> reports_of(const std::vector<Bytes>& rows) {
  std::vector<Bytes> reports;
  for (std::uint32_t number = 0; number < rows.size(); ++number) {
    std::uint16_t chunk = 0;
    for (std::size_t at = 0; at < rows[number].size(); at += Report::payload_bytes) {
      const std::size_t end = std::min(at + Report::payload_bytes, rows[number].size());
      reports.push_back(report_of(Kind::row, number, chunk++,
                                  Bytes(rows[number].begin() + static_cast<std::ptrdiff_t>(at),
                                        rows[number].begin() + static_cast<std::ptrdiff_t>(end))));
    }
  }
  return reports;
}

struct Receiver {
  explicit Receiver(const ScanPlan& plan)
      : recording(plan), assembler(plan.row_bytes(), plan.rows()) {}

  RowAssembler::Received add(const Bytes& report) {
    const RowAssembler::Received received = assembler.add(report.data(), report.size());
    recording.scan.skip(received.lost_rows);
    if (received.has_row) recording.scan.push(assembler.row());
    return received;
  }
  const Bytes& stream() {
    recording.scan.finish();
    return recording.line.bytes;
  }

  Recording recording;
  RowAssembler assembler;
};

// 150 bytes per row: two full reports, and one of 38 bytes.
const ScanPlan plan = plan_of(150, 10, 20);
constexpr std::size_t chunks = 3;

}  // namespace

TEST_CASE("a written report is read back unchanged, and other bytes are rejected") {
  const Bytes payload = {1, 2, 3};
  const Bytes bytes = report_of(Kind::row, 0x12345678, 0x0102, payload);
  CHECK(Bytes(bytes.begin(), bytes.begin() + 12) ==
        Bytes{0x11, 3, 0x02, 0x01, 0x78, 0x56, 0x34, 0x12, 1, 2, 3, 0});
  const auto report = Report::read(bytes.data(), bytes.size());
  REQUIRE(report);
  CHECK(report->kind == Kind::row);
  CHECK(report->number == 0x12345678);
  CHECK(report->chunk == 0x0102);
  CHECK(Bytes(report->payload, report->payload + report->length) == payload);

  CHECK(!Report::read(bytes.data(), 63));
  for (const auto& [at, value] : {std::pair{0, 0x21}, {0, 0x10}, {0, 0x17}, {1, 57}}) {
    Bytes other = bytes;
    other[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
    CHECK(!Report::read(other.data(), other.size()));
  }
}

TEST_CASE("a complete set of reports yields all rows") {
  Receiver receiver(plan);
  for (const Bytes& report : reports_of(rows_of(plan))) receiver.add(report);
  CHECK(receiver.recording.scan.is_whole());
  CHECK(receiver.assembler.lost_reports() == 0);
  CHECK(receiver.stream() == expected_stream(plan, 200));
}

TEST_CASE("repeated reports change nothing") {
  Receiver receiver(plan);
  const std::vector<Bytes> reports = reports_of(rows_of(plan));
  for (std::size_t i = 0; i < reports.size(); ++i) {
    receiver.add(reports[i]);
    receiver.add(reports[i]);
    if (i > 10) receiver.add(reports[i - 10]);
  }
  CHECK(receiver.assembler.repeated_reports() == reports.size() + reports.size() - 11);
  CHECK(receiver.stream() == expected_stream(plan, 200));
}

TEST_CASE("lost reports lose only their own rows and are counted") {
  const std::vector<Bytes> reports = reports_of(rows_of(plan));
  Chance chance(2);
  for (int round = 0; round < 100; ++round) {
    Receiver receiver(plan);
    std::set<std::uint32_t> skipped;
    std::size_t lost = 0;
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < reports.size(); ++i) {
      if (left_out == 0 && chance.below(40) == 0) left_out = 1 + chance.below(9);
      if (left_out > 0) {
        --left_out;
        ++lost;
        skipped.insert(static_cast<std::uint32_t>(i / chunks));
      } else {
        receiver.add(reports[i]);
      }
    }
    CHECK(receiver.add(report_of(Kind::end, 200)).has_ended);
    CHECK(receiver.recording.scan.rows() == 200);
    CHECK(receiver.assembler.lost_reports() == lost);
    CHECK(receiver.stream() == expected_stream(plan, 200, skipped));
  }
}

TEST_CASE("an early end ends the scan at the current row") {
  Receiver receiver(plan);
  const std::vector<Bytes> reports = reports_of(rows_of(plan));
  for (std::size_t i = 0; i < 20 * chunks; ++i) receiver.add(reports[i]);
  CHECK(receiver.add(report_of(Kind::end, 20)).has_ended);
  CHECK(receiver.stream() == expected_stream(plan, 20));
}

TEST_CASE("invalid reports are counted and otherwise ignored") {
  Receiver receiver(plan);
  const std::vector<Bytes> reports = reports_of(rows_of(plan));
  const Bytes full(56, 1);
  const std::vector<Bytes> wrong = {
      report_of(Kind::row, 200, 0, full),         // beyond the last row
      report_of(Kind::row, 0xFFFFFFFF, 0, full),  //
      report_of(Kind::row, 50, 3, full),          // beyond the end of a row
      report_of(Kind::row, 50, 2, full),          // longer than the end of a row
      report_of(Kind::row, 50, 1, Bytes(55, 1)),  // shorter than the middle of a row
      report_of(Kind::end, 201),                  //
      report_of(Kind::start, 0),                  // another device's report
      Bytes(63, 0x11),                            //
      Bytes(64, 0xFF),
  };
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (i < wrong.size()) {
      const RowAssembler::Received received = receiver.add(wrong[i]);
      CHECK(!received.has_row);
      CHECK(!received.has_ended);
    }
    receiver.add(reports[i]);
  }
  CHECK(receiver.assembler.unreadable_reports() == wrong.size());
  CHECK(receiver.stream() == expected_stream(plan, 200));
}

TEST_CASE("random bytes in reports are safe and yield at most the planned number of rows") {
  Chance chance(3);
  for (int round = 0; round < 200; ++round) {
    RowAssembler assembler(1 + chance.below(300), 50);
    std::uint32_t rows = 0;
    for (int i = 0; i < 500; ++i) {
      Bytes bytes(chance.below(8) == 0 ? chance.below(70) : Report::bytes);
      for (std::uint8_t& byte : bytes) byte = chance.byte();
      if (bytes.size() > 8) {
        bytes[0] = static_cast<std::uint8_t>(0x11 + (chance.below(10) == 0));
        bytes[2] &= 3;
        bytes[3] = bytes[5] = bytes[6] = bytes[7] = 0;
        bytes[4] &= 63;
      }
      const RowAssembler::Received received = assembler.add(bytes.data(), bytes.size());
      rows += received.lost_rows + (received.has_row ? 1 : 0);
    }
    CHECK(rows <= 50);
  }
}

TEST_CASE("a stream is sent in full reports, then a partial report and the end report") {
  Bytes stream(1000);
  for (std::size_t i = 0; i < stream.size(); ++i) stream[i] = static_cast<std::uint8_t>(i * 7);
  StreamReports out;
  Bytes received;
  std::uint32_t parts = 0;
  bool has_ended = false;
  const auto send = [&](const StreamReports::Bytes& bytes) {
    const auto report = Report::read(bytes.data(), bytes.size());
    REQUIRE(report);
    CHECK(report->number == parts);
    has_ended = report->kind == Kind::stream_end;
    if (has_ended) return;
    CHECK(report->kind == Kind::stream);
    ++parts;
    received.insert(received.end(), report->payload, report->payload + report->length);
  };
  for (std::size_t at = 0; at < stream.size(); at += 100) {
    out.put(&stream[at], 100);
    out.send_full(send);
    CHECK(received.size() == (at + 100) / 56 * 56);
  }
  out.send_all(send);
  CHECK(has_ended);
  CHECK(received == stream);
  CHECK(parts == 18);
}
