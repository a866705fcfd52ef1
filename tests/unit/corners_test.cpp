// Fragments that are lists of corners, as hosts keep them: what comes out is what comes out of any
// other sweep, wherever they are handed over to it.
#include <discmc/trace/corners.hpp>

#include <doctest/doctest.h>

#include <discmc/trace/corner_sweep.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "oracle/event_log.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;
using trace::Corners;

namespace {

// A volume as rows of bits, with rows around it that are off.
class Rows {
 public:
  explicit Rows(const BitVolume& volume) : volume_(volume), words_(trace::row_words(volume.width)) {
    for (int32_t z = -2; z <= end(volume.depth); ++z)
      for (int32_t y = -2; y <= end(volume.height); ++y)
        for (uint32_t word = 0; word < words_; ++word) bits_.push_back(bits_at(word, y, z));
  }
  trace::SweptRow swept(int32_t y, int32_t z) const {
    trace::SweptRow row{};
    for (int32_t dz = -1; dz <= 1; ++dz)
      for (int32_t dy = -1; dy <= 1; ++dy) row.rows.row[dz + 1][dy + 1] = at(y + dy, z + dz);
    row.words = words_;
    row.width = volume_.width;
    row.y = y;
    row.z = z;
    row.set_missing();
    return row;
  }

 private:
  static int32_t end(uint32_t extent) { return static_cast<int32_t>(extent); }
  uint32_t bits_at(uint32_t word, int32_t y, int32_t z) const {
    uint32_t bits = 0;
    for (uint32_t bit = 0; bit < 32; ++bit)
      if (volume_.at(static_cast<int32_t>(trace::column_of(word, bit)), y, z)) bits |= 1U << bit;
    return bits;
  }
  const uint32_t* at(int32_t y, int32_t z) const {
    const int32_t row = (z + 2) * (end(volume_.height) + 3) + y + 2;
    return &bits_[static_cast<size_t>(row) * words_];
  }

  const BitVolume& volume_;
  uint32_t words_;
  std::vector<uint32_t> bits_;
};

// What a sweep tells of a volume with a closed border, and the records that it has in use then.
struct Told {
  Events events;
  std::array<uint64_t, 8> counts;
  uint32_t in_use;
};

using CornerSweep = trace::CornerSweep;
using PlainSweep = trace::Sweep<uint32_t, NoNormal>;
constexpr uint32_t plenty = 400000;

template <class Sweep>
Told told_by(const BitVolume& volume, uint32_t records, const EventLog::Refuses& refuses = {}) {
  const auto sweep = std::make_unique<Sweep>();
  std::vector<trace::Record<uint32_t, NoNormal>> memory(records);
  trace::Queue<uint32_t> queues[trace::queue_count];
  uint32_t holes[sizing::hole_lists];
  sweep->fragments().start(memory.data(), records, queues, true);
  sweep->delivery().start(holes, 1000, true);
  sweep->clear();
  EventLog log(refuses);
  const Sink sink = sink_to(log);
  Statistics statistics{};
  const Rows rows(volume);
  for (int32_t z = -1; z < static_cast<int32_t>(volume.depth); ++z)
    for (int32_t y = -1; y < static_cast<int32_t>(volume.height); ++y)
      while (!sweep->sweep(rows.swept(y, z), NoNormals{}, sink, statistics)) {
      }
  return {log.events, counts(statistics), sweep->fragments().records().in_use()};
}

// Noise, and behind it a sieve whose holes wait for the ring around them.
BitVolume noise_and_sieve() {
  const BitVolume noise = random({30, 30, 2}, 128, 8);
  BitVolume volume({30, 30, 5});
  std::copy(noise.on.begin(), noise.on.end(), volume.on.begin());
  for (int64_t y = 0; y < 30; ++y)
    for (int64_t x = 0; x < 30; ++x) volume.on[volume.index(x, y, 3)] = x % 3 != 1 || y % 3 != 1;
  return volume;
}

}  // namespace

TEST_CASE("whether and wherever corners are handed over, the events are those of any other sweep") {
  struct Case {
    BitVolume volume;
    uint32_t step;
  };
  const Case cases[] = {{random({30, 30, 3}, 128, 8), 1300},
                        {random({64, 14, 3}, 128, 8), 1700},
                        {random({40, 40, 2}, 60, 8), 700},
                        {columns({30, 30, 3}), 4700}};
  for (const Case& each : cases) {
    const Told expected = told_by<PlainSweep>(each.volume, plenty);
    for (uint32_t i = 0; i < 7; ++i) {
      CAPTURE(i);
      const uint32_t records = i == 6 ? plenty : Corners::least_records + each.step * i;
      const EventLog::Refuses refuses = i % 2 == 0 ? nullptr : refuses_first;
      const Told told = told_by<CornerSweep>(each.volume, records, refuses);
      CHECK(told.events == expected.events);
      CHECK(told.counts == expected.counts);
      // What is handed over is given back in the end.
      CHECK((told.in_use == 0) == (i < 6));
    }
  }
}

TEST_CASE("corners are kept as long as ten records are free for each") {
  struct Known {
    BitVolume volume;
    uint32_t corners;
    uint32_t longer_queues;  // how often one has been made twice as long, the second time twice
    uint32_t holes;          // records of those that wait when most corners do
  };
  const Known all[] = {{random({31, 30, 3}, 128, 8), 2548, 0, 0},
                       {random({40, 40, 3}, 60, 8), 2011, 4, 0},
                       {checkerboard({30, 30, 3}), 2212, 8, 0},
                       {columns({30, 30, 3}), 3956, 20, 0},
                       {noise_and_sieve(), 2129, 0, 256}};
  for (const Known& known : all) {
    CAPTURE(known.corners);
    const uint32_t in_use = Corners::least_records / 2 + 128 * known.longer_queues + known.corners;
    CHECK(told_by<CornerSweep>(known.volume, plenty).in_use == in_use);
    const uint32_t enough = in_use + known.holes + 10 * known.corners;
    CHECK(told_by<CornerSweep>(known.volume, enough).in_use == in_use);
    CHECK(told_by<CornerSweep>(known.volume, enough - 1).in_use == 0);
  }
}

TEST_CASE("a straight side takes no more records when it is longer") {
  const auto in_use = [](const Size& size) {
    const Vertex last{static_cast<int32_t>(size.width) - 1, static_cast<int32_t>(size.height) - 1,
                      static_cast<int32_t>(size.depth) - 1};
    return told_by<CornerSweep>(box(size, {0, 0, 0}, last), plenty).in_use;
  };
  CHECK(in_use({300, 2, 2}) == in_use({600, 2, 2}));
  CHECK(in_use({2, 3, 2}) == in_use({2, 300, 2}));
  CHECK(in_use({2, 2, 3}) == in_use({2, 2, 300}));
}

TEST_CASE("the corners of rings that have closed are used again") {
  const auto in_use = [](uint32_t depth) {
    return told_by<CornerSweep>(tiling({20, 20, depth}, 1), plenty).in_use;
  };
  CHECK(in_use(4) == in_use(40));
}
