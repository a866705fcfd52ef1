// Normals computed during the scan. The events equal those of a scan without normals; the normals
// equal those of a second pass, bit for bit.
#include <discmc/sample_window.hpp>

#include "oracle/checkpointed_device.hpp"
#include "oracle/normal_events.hpp"
#include "oracle/scan.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using namespace discmc::test;

namespace {

template <class Sample>
using WithNormals = detail::trace::GradientIntake<Sample>;

struct Setting {
  int32_t threshold;
  Border border;
  Capacities capacities;
  bool refuses = false;
  uint32_t chunk = 1000000;
  Slab slab = {};
};

template <class Index, class Normals, class Sample>
Events events_of(const SampleVolume<Sample>& volume, const Setting& setting) {
  const Limits limits{volume.size.width, volume.size.height, setting.border, setting.slab};
  Block block(detail::sizing::bytes_for<Index, Normals>(limits, setting.capacities));
  EventLog log(setting.refuses ? EventLog::Refuses(reference::refuses_first) : nullptr);
  typename ExtractorOf<Index, Normals>::Type extractor;
  if constexpr (Normals::holds_samples) extractor.set_spacing(uneven_spacing);
  require_ok(extractor.start(limits, setting.capacities, setting.threshold, block.memory(),
                             make_sink(log)));
  push_all(extractor, volume.samples, setting.chunk);
  finish_all(extractor);
  REQUIRE(block.is_intact());
  return log.events;
}

template <class Sample>
void require_normals(const Events& events, const SampleVolume<Sample>& volume) {
  for_each_start(events, [&](const Vertex& vertex, OctahedralNormal normal, bool is_corner) {
    REQUIRE(normal == (is_corner ? reference_normal(volume, vertex) : OctahedralNormal{}));
  });
}

template <class Sample>
void check_agreement(const SampleVolume<Sample>& volume, const Setting& setting) {
  const Events plain = events_of<uint16_t, detail::trace::BitIntake>(volume, setting);
  const Events events = events_of<uint16_t, WithNormals<Sample>>(volume, setting);
  REQUIRE(without_normals(events) == plain);
  REQUIRE(events_of<uint32_t, WithNormals<Sample>>(volume, setting) == events);
  require_normals(events, volume);
}

// Smooth noise: sums of a few neighbouring random values.
template <class Sample>
SampleVolume<Sample> clouds(Size size, uint64_t seed, uint32_t most = 255) {
  Chance chance(seed);
  std::vector<uint32_t> noise(size_t{size.width} * size.height * size.depth);
  for (uint32_t& value : noise) value = chance.below(most + 1);
  SampleVolume<Sample> volume{size, {}};
  for (size_t i = 0; i < noise.size(); ++i) {
    const size_t j = (i + 1) % noise.size(), k = (i + size.width) % noise.size();
    volume.samples.push_back(static_cast<Sample>((noise[i] + noise[j] + noise[k]) / 3));
  }
  return volume;
}

}  // namespace

TEST_CASE(
    "a scan with normals sends the same surface, with the normals computed in a second pass") {
  for (const Size size : {Size{1, 1, 1}, Size{2, 3, 1}, Size{1, 4, 5}, Size{7, 5, 6},
                          Size{16, 12, 9}, Size{33, 9, 7}})
    for (const Border border : {Border::closed, Border::open})
      for (uint64_t seed = 0; seed < 5; ++seed) {
        check_agreement(clouds<uint8_t>(size, seed), {128, border, ample});
        check_agreement(clouds<uint16_t>(size, seed, 60000), {30000, border, ample});
        check_agreement(clouds<int16_t>(size, seed, 30000), {15000, border, ample});
      }
}

TEST_CASE(
    "normals in a slab equal normals of the whole scan if the slab has the surrounding samples") {
  // Below and above the only on samples there are enough slices for their normals.
  constexpr uint32_t width = 9, height = 8, margin = 4, first = 2;
  SampleVolume<uint8_t> volume = clouds<uint8_t>({width, height, 6 + 2 * margin}, 7);
  constexpr size_t slice = size_t{width} * height;
  for (size_t i = 0; i < volume.samples.size(); ++i)
    if (i / slice < margin || i / slice >= volume.size.depth - margin) volume.samples[i] /= 3;
  Setting setting{128, Border::closed, ample};
  using Normals = WithNormals<uint8_t>;
  const auto regions_of = [](const Events& events) {
    Events regions;
    for (const RecordedEvent& event : events)
      if (!event.is(Event::Kind::layer) && !event.is(Event::Kind::finish)) regions.push_back(event);
    return regions;
  };
  const Events whole = regions_of(events_of<uint16_t, Normals>(volume, setting));
  REQUIRE(whole.size() > 100);
  setting.slab = {first, true, true};
  volume.size.depth -= 2 * (first - 1);
  volume.samples.resize(volume.samples.size() - (first - 1) * slice);
  volume.samples.erase(volume.samples.begin(), volume.samples.begin() + (first - 1) * slice);
  CHECK(regions_of(events_of<uint16_t, Normals>(volume, setting)) == whole);
}

TEST_CASE("normals do not depend on portions of samples or on a sink that refuses events") {
  const Size size{9, 8, 7};
  const SampleVolume<uint8_t> volume = clouds<uint8_t>(size, 42);
  Setting setting{128, Border::closed, ample};
  const Events events = events_of<uint16_t, WithNormals<uint8_t>>(volume, setting);
  for (const bool refuses : {false, true})
    for (const uint32_t chunk : {1U, 5U, 9U, 100U}) {
      setting.refuses = refuses;
      setting.chunk = chunk;
      REQUIRE(events_of<uint16_t, WithNormals<uint8_t>>(volume, setting) == events);
    }
}

TEST_CASE("normals of loose fragments are right if memory is short") {
  const Size size{24, 20, 12};
  for (uint64_t seed = 0; seed < 4; ++seed)
    for (const uint32_t slots : {4U, 5U, 30U, 100U, 300U, 1000U}) {
      const SampleVolume<uint8_t> volume = clouds<uint8_t>(size, seed);
      check_agreement(volume, {128, Border::closed, {slots, slots / 16}});
    }
}

TEST_CASE("a new scan with normals is independent of the previous scan") {
  const SampleVolume<uint8_t> before = clouds<uint8_t>({11, 9, 3}, 1);
  const SampleVolume<uint8_t> volume = clouds<uint8_t>({7, 5, 6}, 2);
  const Setting setting{128, Border::closed, ample};
  const Limits larger{before.size.width, before.size.height};
  const Limits limits{volume.size.width, volume.size.height};
  using Normals = WithNormals<uint8_t>;
  Block block(detail::sizing::bytes_for<uint16_t, Normals>(larger, setting.capacities));
  EventLog log;
  NormalExtractor16<uint8_t> extractor;
  extractor.set_spacing(uneven_spacing);
  require_ok(extractor.start(larger, setting.capacities, setting.threshold, block.memory(),
                             make_sink(log)));
  require_ok(extractor.push(before.samples.data(), 25 * 11 + 3).status);  // abandoned within a row
  log.events.clear();
  require_ok(extractor.start(limits, setting.capacities, setting.threshold, block.memory(),
                             make_sink(log)));
  push_all(extractor, volume.samples, setting.chunk);
  finish_all(extractor);
  CHECK(log.events == events_of<uint16_t, Normals>(volume, setting));
}

TEST_CASE("thresholds below or above all samples yield the same surface with and without normals") {
  const Size size{5, 4, 3};
  for (const int32_t threshold : {INT32_MIN, -1, 0, 1, 255, 256, INT32_MAX})
    check_agreement(clouds<uint8_t>(size, 3), {threshold, Border::closed, ample});
}

TEST_CASE("the normals at the corners of a ball point outwards") {
  const int32_t extent = 24;
  SampleVolume<uint8_t> ball{{extent, extent, extent}, {}};
  for (int32_t z = 0; z < extent; ++z)
    for (int32_t y = 0; y < extent; ++y)
      for (int32_t x = 0; x < extent; ++x) {
        const Vertex v{2 * x - extent + 1, 2 * y - extent + 1, 2 * z - extent + 1};
        ball.samples.push_back(static_cast<uint8_t>(std::max(0, 255 - dot_product(v, v) / 4)));
      }
  const Events events =
      events_of<uint32_t, WithNormals<uint8_t>>(ball, {180, Border::closed, ample});
  int starts = 0;
  for_each_start(events, [&](const Vertex& vertex, OctahedralNormal normal, bool) {
    ++starts;
    REQUIRE(!normal.is_none());
    const UnitNormal n = unit_normal(normal);
    const Vertex from_centre{vertex.x - extent + 1, vertex.y - extent + 1, vertex.z - extent + 1};
    // In space, y is mirrored.
    const int64_t outwards = int64_t{n.x} * from_centre.x * uneven_spacing[0] +
                             int64_t{n.y} * from_centre.y * uneven_spacing[1] +
                             int64_t{n.z} * from_centre.z * uneven_spacing[2];
    REQUIRE(outwards > 0);
  });
  CHECK(starts > 1000);
}

TEST_CASE("a small scan with normals sends the same surface, even at open borders and seams") {
  constexpr Capacities few{500, 60};
  for (const uint32_t height : {1U, 2U, 4U})
    for (const Border border : {Border::closed, Border::open})
      for (const Slab& slab : {Slab{}, Slab{0, false, true}, Slab{3, true, false}}) {
        const SampleVolume<uint8_t> volume = clouds<uint8_t>({5, height, 4}, height);
        Setting setting{128, border, few};
        setting.slab = slab;
        CHECK(without_normals(events_of<uint16_t, WithNormals<uint8_t>>(volume, setting)) ==
              events_of<uint16_t, detail::trace::BitIntake>(volume, setting));
      }
}

TEST_CASE("an extractor with normals sweeps a slice one slice and one row later") {
  using Normals = WithNormals<uint8_t>;
  const Limits limits{8, 3};
  CHECK(Normals::bytes_for(limits) == (4 * 3 + 6) * (8 + sizeof(uint16_t)) + 2 * red_zone_bytes);
  const std::vector<uint8_t> samples(7 * limits.width, 0);
  Block block(detail::sizing::minimum_bytes<uint16_t, Normals>(limits));
  EventLog log;
  NormalExtractor16<uint8_t> extractor;
  require_ok(extractor.start(limits, 1, block.memory(), make_sink(log)));
  CHECK_FALSE(log.starts.front().has_spacing());
  for (const int32_t spacing : log.starts.front().spacing_nm) CHECK(spacing == 0);
  require_ok(extractor.push(samples.data(), 6 * limits.width).status);
  CHECK(log.events.empty());
  require_ok(extractor.push(samples.data(), limits.width).status);
  REQUIRE(log.events.size() == 1);
  CHECK(log.events.front().is(Event::Kind::layer));
}

// ---- missing rows ----

namespace {

enum class Ending : uint8_t { finish, abandon };
enum class Row : uint8_t { given, off, repeated };

std::vector<Row> some_rows(uint32_t count, Chance& chance) {
  std::vector<Row> rows;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t kind = chance.below(6);
    rows.push_back(kind == 0 ? Row::off : kind == 1 ? Row::repeated : Row::given);
  }
  return rows;
}

// Pushes the given rows, skips the others, and ends within the next row if the scan is abandoned.
template <class Normals>
Events events_with_gaps(const SampleVolume<uint8_t>& volume, const std::vector<Row>& rows,
                        int32_t threshold, Ending ending, uint32_t part = 0) {
  const Limits limits{volume.size.width, volume.size.height};
  Block block(detail::sizing::bytes_for<uint16_t, Normals>(limits, ample));
  EventLog log;
  typename ExtractorOf<uint16_t, Normals>::Type extractor;
  if constexpr (Normals::holds_samples) extractor.set_spacing(uneven_spacing);
  require_ok(extractor.start(limits, ample, threshold, block.memory(), make_sink(log)));
  const uint8_t* samples = volume.samples.data();
  for (uint32_t row = 0; row < rows.size(); ++row, samples += volume.size.width) {
    REQUIRE(extractor.slices() == row / volume.size.height);
    REQUIRE(extractor.rows() == row % volume.size.height);
    const PushResult pushed = rows[row] == Row::given ? extractor.push(samples, volume.size.width)
                              : rows[row] == Row::off
                                  ? extractor.skip_row(Substitute::off)
                                  : extractor.skip_row(Substitute::previous_row);
    require_ok(pushed.status);
  }
  if (ending == Ending::abandon) {
    require_ok(extractor.push(samples, part).status);
    if (part > 0) {
      REQUIRE(extractor.skip_row(Substitute::off).status == Status::row_in_progress);
      REQUIRE(extractor.finish() == Status::slice_in_progress);
    }
    require_ok(extractor.abandon());
  } else {
    require_ok(extractor.finish());
  }
  REQUIRE(extractor.push(volume.samples.data(), 1).status == Status::finished);
  REQUIRE(block.is_intact());
  return log.events;
}

// The volume of a scan with missing rows: other rows replace them, or they are off.
SampleVolume<uint8_t> with_gaps(SampleVolume<uint8_t> volume, const std::vector<Row>& rows,
                                uint8_t off) {
  const auto width = static_cast<std::ptrdiff_t>(volume.size.width);
  auto samples = volume.samples.begin();
  for (size_t row = 0; row < rows.size(); ++row, samples += width) {
    if (rows[row] == Row::given) continue;
    if (rows[row] == Row::repeated && row > 0)
      std::copy(samples - width, samples, samples);
    else
      std::fill(samples, samples + width, off);
  }
  return volume;
}

}  // namespace

TEST_CASE("skipped rows and unfinished slices yield the same surface with and without normals") {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Size size{1 + static_cast<uint32_t>(seed % 7), 1 + static_cast<uint32_t>(seed % 5),
                    1 + static_cast<uint32_t>(seed % 6)};
    const SampleVolume<uint8_t> volume = clouds<uint8_t>(size, seed);
    Chance chance(seed);
    const uint32_t all = size.height * size.depth;
    for (const Ending ending : {Ending::finish, Ending::abandon})
      for (const int32_t threshold : {0, 128, 300}) {
        const bool is_broken = ending == Ending::abandon;
        const std::vector<Row> rows = some_rows(is_broken ? chance.below(all) : all, chance);
        const uint32_t part = is_broken ? chance.below(size.width) : 0;
        const Events plain =
            events_with_gaps<detail::trace::BitIntake>(volume, rows, threshold, ending, part);
        const Events events =
            events_with_gaps<WithNormals<uint8_t>>(volume, rows, threshold, ending, part);
        REQUIRE(without_normals(events) == plain);
      }
  }
}

TEST_CASE("normals beside skipped rows use the substitutes, or samples just below the threshold") {
  const Size size{5, 4, 6};
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const SampleVolume<uint8_t> volume = clouds<uint8_t>(size, seed);
    Chance chance(seed);
    const std::vector<Row> rows = some_rows(size.height * size.depth, chance);
    for (const int32_t threshold : {-1, 0, 1, 128}) {
      const auto off = static_cast<uint8_t>(std::max(threshold - 1, 0));
      const SampleVolume<uint8_t> seen = with_gaps(volume, rows, off);
      const Events events =
          events_with_gaps<WithNormals<uint8_t>>(volume, rows, threshold, Ending::finish);
      require_normals(events, seen);
    }
  }
}

TEST_CASE("missing samples of an abandoned scan count as just below the threshold for normals") {
  const Size size{4, 3, 5};
  const Limits limits{size.width, size.height};
  const int32_t threshold = 100;
  // The minimum memory, so every cell sends its normals when it is swept.
  const Capacities minimum = minimum_capacities();
  for (uint32_t given = 1; given <= size.width * size.height * size.depth; ++given) {
    SampleVolume<uint8_t> volume = clouds<uint8_t>(size, given);
    Block block(detail::sizing::bytes_for<uint16_t, WithNormals<uint8_t>>(limits, minimum));
    EventLog log;
    NormalExtractor16<uint8_t> extractor;
    extractor.set_spacing(uneven_spacing);
    require_ok(extractor.start(limits, minimum, threshold, block.memory(), make_sink(log)));
    require_ok(extractor.push(volume.samples.data(), given).status);
    require_ok(extractor.abandon());
    const uint32_t slice = size.width * size.height;
    volume.size.depth = (given + slice - 1) / slice;
    for (size_t i = given; i < volume.samples.size(); ++i) volume.samples[i] = threshold - 1;
    require_normals(log.events, volume);
  }
}

TEST_CASE("a scan with normals restored between rows continues with the same events") {
  const Size size{8, 6, 5};
  const Limits limits{size.width, size.height};
  const SampleVolume<uint8_t> volume = clouds<uint8_t>(size, 9);
  const Setting setting{128, Border::closed, ample};
  const Events whole = events_of<uint16_t, WithNormals<uint8_t>>(volume, setting);
  using Scan = NormalExtractor16<uint8_t>;
  for (uint32_t row = 0; row <= size.height * size.depth; ++row) {
    const size_t bytes =
        detail::sizing::bytes_for<uint16_t, WithNormals<uint8_t>>(limits, setting.capacities);
    std::vector<uint8_t> memory(bytes), later(bytes);
    EventLog log;
    Scan first;
    first.set_spacing(uneven_spacing);
    require_ok(
        first.start(limits, setting.capacities, 128, {memory.data(), bytes}, make_sink(log)));
    require_ok(first.push(volume.samples.data(), row * size.width).status);
    Scan second;
    require_ok(test::move_scan(first, second, {later.data(), bytes}, make_sink(log)));
    REQUIRE(second.slices() == row / size.height);
    require_ok(second
                   .push(volume.samples.data() + size_t{row} * size.width,
                         (size.height * size.depth - row) * size.width)
                   .status);
    require_ok(second.finish());
    REQUIRE(log.events == whole);
  }
}

TEST_CASE("restore() refuses a checkpoint of another sample type") {
  using Scan = NormalExtractor16<uint16_t>;
  using Other = NormalExtractor16<int16_t>;
  const Limits limits{8, 6};
  Block block(detail::sizing::minimum_bytes<uint16_t, WithNormals<uint16_t>>(limits));
  EventLog log;
  Scan scan;
  require_ok(scan.start(limits, 1, block.memory(), make_sink(log)));
  Memory parts[2];
  require_ok(scan.save(parts));
  Other other;
  static_assert(sizeof other == sizeof scan);
  test::read_back(test::image_of({parts[0]}), {memory_of(other)});
  CHECK(other.restore(block.memory(), make_sink(log)) == Status::bad_checkpoint);
  CHECK(scan.restore(block.memory(), make_sink(log)) == Status::ok);
}

TEST_CASE("memory for normals is required at the start and counted in bytes_used()") {
  const Limits limits{16, 9};
  using Normals = WithNormals<uint16_t>;
  const size_t minimum = detail::sizing::minimum_bytes<uint16_t, Normals>(limits);
  CHECK(minimum >= Extractor16::minimum_bytes(limits) + 16 * (4 * 9 + 6) * 2);
  Block block(minimum);
  const Memory memory = block.memory();
  EventLog log;
  NormalExtractor16<uint16_t> extractor;
  CHECK(extractor.start(limits, 1, {memory.data, minimum - 1}, make_sink(log)) ==
        Status::too_little_memory);
  CHECK(extractor.start(limits, 1, memory, make_sink(log)) == Status::ok);
  CHECK(extractor.bytes_used() <= minimum);
  CHECK(extractor.bytes_used() > Extractor16::minimum_bytes(limits) + 16 * (4 * 9 + 6) * 2);
  const uint64_t more = minimum + 4096;
  const Capacities capacities = detail::sizing::default_capacities<uint16_t, Normals>(limits, more);
  CHECK(detail::sizing::bytes_for<uint16_t, Normals>(limits, capacities) <= more);
  CHECK(detail::sizing::bytes_for<uint16_t, Normals>(limits, capacities) > more - 500);
}
