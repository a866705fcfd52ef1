// Fragments that are lists of corners, as hosts keep them: what comes out is what comes out of any
// other sweep, wherever they are handed over to it.
#include <discmc/host/corners.hpp>

#include <doctest/doctest.h>

#include <discmc/host/corner_sweep.hpp>

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
      for (int32_t dy = -1; dy <= 1; ++dy) row.around.row[dz + 1][dy + 1] = at(y + dy, z + dz);
    row.words = words_;
    row.width = volume_.width;
    row.y = y;
    row.z = z;
    row.set_absent_quadrants();
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

// What a sweep tells of a volume with a closed border, and the slots that it has in use then.
struct Told {
  Events events;
  std::array<uint64_t, 8> counts;
  uint32_t in_use;
};

constexpr uint32_t plenty = 250000;

// A sweep without the extractor around it.
template <class Sweep>
class Scanner {
 public:
  explicit Scanner(uint32_t slots) : memory_(bytes_for<uint32_t>({1, 1}, {slots, 1000})) {
    Arena arena({memory_.data(), memory_.size()});
    sweep_->start(arena, {slots, 1000});
  }

  // lowest: the number of the volume's first slice.
  Told scan(const BitVolume& volume, const EventLog::Refuses& refuses = {}, int32_t lowest = 0) {
    EventLog log(refuses);
    Statistics statistics{};
    sweep_->clear();
    uint64_t pauses = 0;
    sweep(volume, lowest, [&](const trace::SweptRow& row) {
      while (!sweep_->sweep(row, BitIntake{}, make_sink(log), statistics)) ++pauses;
      return true;
    });
    CHECK(pauses == log.refusals());
    return {log.events, counts(statistics), sweep_->fragments().slots().in_use()};
  }
  // Ends where the sink refuses an event.
  void break_off(const BitVolume& volume, uint64_t event) {
    EventLog log([event](uint64_t offer) { return offer >= event; });
    Statistics statistics{};
    sweep_->clear();
    sweep(volume, 0, [&](const trace::SweptRow& row) {
      return sweep_->sweep(row, BitIntake{}, make_sink(log), statistics);
    });
  }

 private:
  template <class Visit>
  static void sweep(const BitVolume& volume, int32_t lowest, Visit visit) {
    const Rows rows(volume);
    for (int32_t z = -1; z < static_cast<int32_t>(volume.depth); ++z)
      for (int32_t y = -1; y < static_cast<int32_t>(volume.height); ++y) {
        trace::SweptRow row = rows.swept(y, z);
        row.z += lowest;
        if (!visit(row)) return;
      }
  }

  std::unique_ptr<Sweep> sweep_ = std::make_unique<Sweep>();
  std::vector<uint8_t> memory_;
};

using Corner = Scanner<trace::CornerSweep>;
using Plain = Scanner<trace::Sweep<uint32_t, NoNormal>>;

// With so many slots: does not hand over what it keeps, which is in use to the end.
bool keeps_corners(const BitVolume& volume, uint32_t slots) {
  return Corner(slots).scan(volume).in_use > 0;
}

// Two slices of noise, and another volume behind it, no larger in a slice.
BitVolume noise_and(uint32_t width, const BitVolume& other) {
  BitVolume volume({width, width, 3 + other.depth});
  const BitVolume noise = random({width, width, 2}, 128, 8);
  std::copy(noise.on.begin(), noise.on.end(), volume.on.begin());
  for (uint32_t z = 0; z < other.depth; ++z)
    for (uint32_t y = 0; y < other.height; ++y)
      std::copy_n(&other.on[other.index(0, y, z)], other.width,
                  &volume.on[volume.index(0, y, z + 3)]);
  return volume;
}
BitVolume plate_with_a_hole() {
  BitVolume plate = box({5, 5, 1}, {0, 0, 0}, {4, 4, 0});
  plate.on[plate.index(2, 2, 0)] = 0;
  return plate;
}

// A slice thick; one of its sides goes diagonally through all rows.
BitVolume wedge(uint32_t length) {
  BitVolume volume({length, 1, length});
  for (uint32_t z = 0; z < length; ++z)
    for (uint32_t x = z; x < length; ++x) volume.on[volume.index(x, 0, z)] = 1;
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
    const Told expected = Plain(plenty).scan(each.volume);
    for (uint32_t i = 0; i < 7; ++i) {
      CAPTURE(i);
      const uint32_t slots = i == 6 ? plenty : Corners::min_slots + each.step * i;
      const Told told = Corner(slots).scan(each.volume, i % 2 == 0 ? nullptr : refuses_first);
      CHECK(told.events == expected.events);
      CHECK(told.counts == expected.counts);
      // What is handed over is given back in the end.
      CHECK((told.in_use == 0) == (i < 6));
    }
  }
}

TEST_CASE("sides longer than two places can tell are handed over") {
  for (const BitVolume& volume : {wedge(1100), box({1, 1, 4300}, {0, 0, 0}, {0, 0, 4299})}) {
    const auto lowest = trace::CornerCode::max_slices - static_cast<int32_t>(volume.depth) + 9;
    const Told expected = Plain(plenty).scan(volume, {}, lowest);
    const Told told = Corner(plenty).scan(volume, {}, lowest);
    CHECK(told.events == expected.events);
    CHECK(told.in_use == 0);
  }
}

TEST_CASE("corners are kept as long as ten slots are free for each") {
  struct Known {
    BitVolume volume;
    uint32_t corners;
    uint32_t longer;  // slots by which queues have grown
    uint32_t others;  // slots that are in use besides for a while, when most corners are
  };
  const Known all[] = {{random({31, 30, 3}, 128, 8), 2548, 0, 0},
                       {random({40, 40, 3}, 60, 8), 2011, 512, 0},
                       {columns({30, 30, 3}), 3956, 2560, 0},
                       // The two slots of a hole, and two of its runs.
                       {noise_and(30, plate_with_a_hole()), 2129, 0, 4},
                       // Those of a queue that has just grown; the last one has so for the second
                       // time.
                       {checkerboard({30, 30, 3}), 2212, 1024, 128},
                       {noise_and(30, columns({20, 20, 2})), 2129, 512, 128},
                       {noise_and(60, columns({30, 30, 2})), 7920, 4608, 256}};
  for (const Known& known : all) {
    CAPTURE(known.corners);
    const uint32_t in_use = Corners::min_slots / 2 + known.longer + known.corners;
    const Told told = Corner(plenty).scan(known.volume);
    CHECK(told.in_use == in_use);
    CHECK(told.events == Plain(plenty).scan(known.volume).events);
    const uint32_t enough = in_use + known.others + 10 * known.corners;
    CHECK(keeps_corners(known.volume, enough));
    CHECK_FALSE(keeps_corners(known.volume, enough - 1));
  }
}

TEST_CASE("in no queue is an end lost, however many wait there for the next row") {
  BitVolume stripes({1100, 3, 3});
  for (int64_t x = 0; x < 1100; x += 2)
    for (int64_t y = 0; y < 3; ++y) stripes.on[stripes.index(x, y, 1)] = 1;
  const Told told = Corner(plenty).scan(stripes);
  CHECK(told.events == Plain(plenty).scan(stripes).events);
  CHECK(told.in_use > 0);
}

TEST_CASE("with fewer slots than the least no corners are kept") {
  const BitVolume voxel = box({1, 1, 1}, {0, 0, 0}, {0, 0, 0});
  CHECK(keeps_corners(voxel, Corners::min_slots));
  CHECK_FALSE(keeps_corners(voxel, Corners::min_slots - 1));
}

TEST_CASE("a straight side takes no more slots when it is longer") {
  const auto in_use = [](const Size& size) {
    const Vertex last{static_cast<int32_t>(size.width) - 1, static_cast<int32_t>(size.height) - 1,
                      static_cast<int32_t>(size.depth) - 1};
    return Corner(plenty).scan(box(size, {0, 0, 0}, last)).in_use;
  };
  CHECK(in_use({300, 2, 2}) == in_use({600, 2, 2}));
  CHECK(in_use({2, 3, 2}) == in_use({2, 300, 2}));
  CHECK(in_use({2, 2, 3}) == in_use({2, 2, 300}));
}

TEST_CASE("the corners of rings that have closed are used again") {
  const auto in_use = [](uint32_t depth) {
    return Corner(plenty).scan(tiling({20, 20, depth}, 1)).in_use;
  };
  CHECK(in_use(4) == in_use(40));
}

TEST_CASE("a scan that breaks off leaves nothing to the next") {
  const BitVolume volume = random({31, 30, 3}, 128, 8);
  const Told expected = Plain(plenty).scan(volume);
  Corner scanner(Corners::min_slots);
  for (const uint64_t event : {0U, 1000U, 5000U, 15000U}) {
    scanner.break_off(volume, event);
    const Told told = scanner.scan(volume);
    CHECK(told.events == expected.events);
    CHECK(told.counts == expected.counts);
    CHECK(told.in_use == 0);
  }
}
