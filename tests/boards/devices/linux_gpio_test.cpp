// A scan driven by GPIO lines: an edge is a row, a missed edge is a skipped row, and no row is
// shifted.
#include <unistd.h>
#include <gpio/triggered_scan.hpp>

#include <cstdio>
#include <fstream>

#include "linux_scan.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::device;
using namespace discmc::test;

namespace {

constexpr std::uint64_t ms = 1'000'000;

LineEvent edge_at(std::uint64_t time_ns, bool may_follow_loss = false) {
  LineEvent edge{LineRole::sync, true, time_ns};
  edge.may_follow_loss = may_follow_loss;
  return edge;
}
LineEvent numbered_edge(std::uint32_t number) {
  LineEvent edge{LineRole::sync, true, number * ms};
  edge.number = number;
  return edge;
}

// Linux's queue for the events of an unnumbered line: while 16 wait, further events are dropped.
// Edges come at the given times. The reader reads all waiting events at times of its own.
class KernelQueue {
 public:
  explicit KernelQueue(std::vector<std::uint64_t> times) : times_(std::move(times)) {}

  /// Units: nanoseconds.
  std::vector<LineEvent> read(std::uint64_t now) {
    while (next_ < times_.size() && times_[next_] <= now) {
      if (waiting_.size() < 16) waiting_.push_back(next_);
      ++next_;
    }
    std::vector<LineEvent> events;
    if (waiting_.empty()) return events;
    for (const std::size_t edge : waiting_) {
      seen.push_back(edge);
      events.push_back(edge_at(times_[edge], was_full_));
    }
    was_full_ = waiting_.size() == 16;
    waiting_.clear();
    return events;
  }
  std::size_t arrived() const { return next_; }
  bool is_over() const { return next_ == times_.size() && waiting_.empty(); }

  std::vector<std::size_t> seen;

 private:
  std::vector<std::uint64_t> times_;
  std::size_t next_ = 0;
  std::vector<std::size_t> waiting_;
  bool was_full_ = false;
};

struct Stage {
  explicit Stage(const ScanPlan& plan, bool has_button = false)
      : recording(plan),
        source(simulated_rows(plan.dims, plan.type)),
        triggered(recording.scan, *source, plan.row_bytes(), has_button) {}

  void edges(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      now += 2 * ms;
      triggered.process(edge_at(now));
    }
  }
  void press(std::uint64_t length_ns = 200 * ms) {
    now += 50 * ms;
    triggered.process({LineRole::button, true, now});
    now += length_ns;
    triggered.process({LineRole::button, false, now});
  }
  const Bytes& stream() {
    recording.scan.finish();
    return recording.line.bytes;
  }

  Recording recording;
  std::unique_ptr<RowSource> source;
  TriggeredScan triggered;
  std::uint64_t now = 0;
};

using State = TriggeredScan::State;

}  // namespace

TEST_CASE("gaps in the numbers of received edges count as missed edges") {
  EdgeCounter counter;
  CHECK(counter.missed_before(numbered_edge(1)) == 0);
  CHECK(counter.missed_before(numbered_edge(2)) == 0);
  CHECK(counter.missed_before(numbered_edge(6)) == 3);
  CHECK(counter.missed_before(numbered_edge(7)) == 0);
}

TEST_CASE("edges missed before the first received edge count as missed") {
  EdgeCounter counter;
  CHECK(counter.missed_before(numbered_edge(4)) == 3);
}

TEST_CASE("edge numbers that wrap to 0 cause no missed edges") {
  EdgeCounter counter;
  (void)counter.missed_before(numbered_edge(0xFFFFFFFE));
  CHECK(counter.missed_before(numbered_edge(1)) == 2);
}

TEST_CASE("a long interval counts as missed edges only if the queue was full before it") {
  EdgeCounter counter;
  for (std::uint64_t i = 0; i < 20; ++i) CHECK(counter.missed_before(edge_at(i * 2 * ms)) == 0);
  CHECK(counter.missed_before(edge_at(60 * ms)) == 0);
  CHECK(counter.long_intervals() == 1);
  CHECK(counter.missed_before(edge_at(82 * ms, true)) == 10);
  CHECK(counter.long_intervals() == 1);
}

TEST_CASE("an interval of one period after a full queue counts as no missed edge") {
  EdgeCounter counter;
  for (std::uint64_t i = 0; i < 16; ++i) (void)counter.missed_before(edge_at(i * 2 * ms));
  CHECK(counter.missed_before(edge_at(32 * ms, true)) == 0);
}

TEST_CASE("edges dropped by a full queue count as missed for any pace, jitter and pauses") {
  Chance chance(1);
  for (int round = 0; round < 300; ++round) {
    const std::uint64_t period = 20'000 + chance.next() % (20 * ms);
    std::vector<std::uint64_t> times;
    std::uint64_t time = ms;
    for (int i = 0; i < 400; ++i) {
      const std::uint64_t jitter = chance.next() % (period / 5);
      times.push_back(time + jitter);
      time += period;
      if (i % 90 == 80) time += 50 * period;  // the stage reverses
    }
    KernelQueue queue(times);
    EdgeCounter counter;
    std::vector<std::size_t> rows;  // the edge assigned to each row
    std::size_t row = 0;
    // Up to 30 periods late, but never across a reversal, where timestamps are ambiguous.
    for (std::uint64_t now = 0; !queue.is_over();) {
      now += period / 2;
      const std::size_t at = queue.arrived() % 90;
      if (chance.below(20) == 0 && at > 10 && at < 45) now += chance.below(30) * period;
      for (const LineEvent& event : queue.read(now)) {
        row += counter.missed_before(event);
        rows.push_back(row++);
      }
    }
    CHECK(rows == queue.seen);
  }
}

TEST_CASE("a press is reported on release, as brief or lengthy") {
  Button button;
  CHECK(button.update(true, 100 * ms) == Button::Press::none);
  CHECK(button.update(false, 300 * ms) == Button::Press::brief);
  CHECK(button.update(true, 2000 * ms) == Button::Press::none);
  CHECK(button.update(false, 3000 * ms) == Button::Press::lengthy);
  CHECK(button.update(true, 4000 * ms) == Button::Press::none);
  CHECK(button.update(false, 4999 * ms) == Button::Press::brief);
}

TEST_CASE("a bouncing button counts as pressed once") {
  Button button;
  CHECK(button.update(true, 100 * ms) == Button::Press::none);
  CHECK(button.update(false, 101 * ms) == Button::Press::none);
  CHECK(button.update(true, 103 * ms) == Button::Press::none);
  CHECK(button.update(false, 300 * ms) == Button::Press::brief);
  CHECK(button.update(true, 302 * ms) == Button::Press::none);
  CHECK(button.update(false, 303 * ms) == Button::Press::none);
}

TEST_CASE("1,000 edges yield 1,000 rows and end the scan") {
  const ScanPlan plan = plan_of(30, 20, 50);
  Stage stage(plan);
  stage.edges(999);
  CHECK(stage.triggered.state() == State::running);
  stage.edges(10);
  CHECK(stage.triggered.state() == State::ended);
  CHECK(stage.recording.scan.is_whole());
  CHECK(stage.stream() == expected_stream(plan, 1000));
}

TEST_CASE("a missed edge skips its row, and later rows keep their row numbers") {
  const ScanPlan plan = plan_of(30, 20, 50);
  Stage stage(plan);
  std::set<std::uint32_t> missed;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    if (i % 100 > 96 || i == 0)
      missed.insert(i);
    else
      stage.triggered.process(numbered_edge(i + 1));
  }
  // The edges after the last received one are missed silently, so only the rows show the loss.
  CHECK(stage.recording.scan.rows() == 997);
  CHECK(stage.triggered.missed() == missed.size() - 3);
  CHECK(stage.triggered.first_missed_row() == 0);
  stage.triggered.process({LineRole::end_stop, true, 2000 * ms});
  CHECK(!stage.recording.scan.is_whole());
  const Bytes& stream = stage.stream();
  CHECK(stream == expected_stream(plan, 997, missed));
  CHECK(decode(stream).report.is_abandoned);
}

TEST_CASE("more missed edges than remaining rows end the scan") {
  const ScanPlan plan = plan_of(10, 5, 4);
  Stage stage(plan);
  stage.edges(10);
  stage.triggered.process(edge_at(10'000 * ms, true));
  CHECK(stage.triggered.state() == State::ended);
  CHECK(stage.recording.scan.rows() == 20);
}

TEST_CASE("a button starts, pauses and ends a scan, and edges during a pause yield no rows") {
  const ScanPlan plan = plan_of(30, 20, 50);
  Stage stage(plan, true);
  stage.edges(7);
  CHECK(stage.triggered.state() == State::waiting);
  stage.press();
  stage.edges(400);
  stage.press();
  CHECK(stage.triggered.state() == State::paused);
  stage.edges(9);
  CHECK(stage.recording.scan.rows() == 400);
  stage.press();
  stage.edges(200);
  stage.press(1500 * ms);
  CHECK(stage.triggered.state() == State::ended);
  stage.edges(1);
  CHECK(stage.recording.scan.rows() == 600);
  CHECK(stage.stream() == expected_stream(plan, 600));
}

TEST_CASE(
    "an end-stop between slices completes the stream, and one within a slice abandons the stream") {
  const ScanPlan plan = plan_of(30, 20, 50);
  for (const std::uint32_t rows : {0U, 40U, 41U}) {
    CAPTURE(rows);
    Stage stage(plan);
    stage.edges(rows);
    stage.triggered.process({LineRole::end_stop, true, stage.now + 1});
    CHECK(stage.triggered.state() == State::ended);
    const Bytes& stream = stage.stream();
    CHECK(stream == expected_stream(plan, rows));
    const StreamReport report = decode(stream).report;
    CHECK(report.is_complete());
    CHECK(report.is_abandoned == (rows == 41));
  }
}

TEST_CASE("16-bit samples are sent with the low byte first") {
  for (const auto type : {meshing::SampleType::u16, meshing::SampleType::i16}) {
    ScanPlan plan = plan_of(2, 1, 1, type);
    plan.threshold = 0x0100;
    Recording recording(plan);
    const std::uint8_t row[] = {0xFF, 0x00, 0x00, 0x01};
    recording.scan.push(row);
    recording.scan.finish();
    CHECK(recording.scan.statistics().cells == 8);  // around one voxel
  }
}

TEST_CASE("too little memory is refused, and the message contains the required number of bytes") {
  ScanPlan plan = plan_of(30, 20, 50);
  plan.memory = 100;
  const std::string minimum = std::to_string(Extractor16::minimum_bytes({30, 20}));
  CHECK_THROWS_WITH_AS(Recording{plan}, doctest::Contains(minimum.c_str()), std::invalid_argument);
}

TEST_CASE("a file returns rows by number, and a pipe returns the next row") {
  char name[] = "/tmp/discmc_rows_XXXXXX";
  REQUIRE(close(mkstemp(name)) == 0);
  std::ofstream(name) << "aabbccdd";
  Bytes row(2);
  const auto text = [&row] { return std::string(row.begin(), row.end()); };

  const auto file = open_rows(name);
  CHECK(file->read(2, row));
  CHECK(text() == "cc");
  CHECK(file->read(0, row));
  CHECK(text() == "aa");
  CHECK(!file->read(4, row));

  int ends[2];
  REQUIRE(pipe(ends) == 0);
  REQUIRE(write(ends[1], "aabbc", 5) == 5);
  close(ends[1]);
  const auto device = open_rows("/dev/fd/" + std::to_string(ends[0]));
  CHECK(device->read(2, row));
  CHECK(text() == "aa");
  CHECK(device->read(7, row));
  CHECK(text() == "bb");
  CHECK(!device->read(8, row));  // an incomplete row does not count
  close(ends[0]);
  std::remove(name);
}
