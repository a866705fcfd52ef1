// Fuzz target. Any small volume yields the regions of the paper's Merge once loose fragments are
// joined, for any portions, memory and refusals. In the memory of the worst case no fragment is
// loose. Index width, portions, refusals and a host extractor, also in slabs, do not change the
// result. The rings split into simple rings of the same area. The voxels are those of the input, or
// of a generated shape.
//
//   fuzz_merge -max_len=400 corpus/merge      with libFuzzer
//   fuzz_merge corpus/merge                   with replay_main.cpp

#include <discmc/polygon.hpp>
#include "host/host_extractor.hpp"

#include <algorithm>
#include <type_traits>

#include "input.hpp"
#include "little_memory.hpp"
#include "oracle/event_log.hpp"
#include "oracle/minimum_host.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "require.hpp"
#include "shapes/sizes.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

/// The caller's action for one row of the volume.
enum class Feed : uint8_t { samples, strided, bits, skip_off, skip_repeated };

struct Scenario {
  Limits limits;
  Capacities capacities;
  bool has_all_memory;
  bool is_abandoned;
  bool is_wide;
  uint32_t chunk;          ///< samples per push
  uint32_t refusals;       ///< refused offers per 256
  uint32_t refusal_seed;   ///< which of them
  std::vector<Feed> feed;  ///< by row of the whole volume
  uint32_t last_samples;   ///< of one more row, if the scan is abandoned
  BitVolume volume;        ///< as the extractor receives them, including substitutes
  shapes::On shape;        ///< of the voxels, if they are generated
  Size wide_size;          ///< of the volume that is scanned in slabs
};

constexpr uint32_t max_slices = 7;

Capacities read_capacities(Input& input, const Limits& limits, bool is_wide) {
  switch (input.below(4)) {
    case 0:  // enough for any volume
      return is_wide ? worst_case_capacities(limits, max_slices) : ample;
    case 1: {
      const uint64_t room = input.word();
      return is_wide ? Extractor32::default_capacities(limits,
                                                       Extractor32::minimum_bytes(limits) + room)
                     : Extractor16::default_capacities(limits,
                                                       Extractor16::minimum_bytes(limits) + room);
    }
    case 2:  // few holes may wait
      return {ample.slots, input.below(8)};
    default:
      return read_little_memory(input);
  }
}

bool holds_all(const Capacities& c, const Capacities& needed) {
  return c.slots >= needed.slots && c.holes >= needed.holes;
}

void read_row(Input& input, Scenario& scenario, size_t row, Feed feed) {
  BitVolume& volume = scenario.volume;
  const auto begin = volume.on.begin() + static_cast<std::ptrdiff_t>(row * volume.width);
  if (feed == Feed::skip_off) return;
  if (feed == Feed::skip_repeated) {
    if (row > 0) std::copy_n(begin - volume.width, volume.width, begin);
    return;
  }
  if (scenario.shape) {
    const auto y = static_cast<uint32_t>(row % volume.height);
    const auto z = static_cast<uint32_t>(row / volume.height);
    for (uint32_t x = 0; x < volume.width; ++x) begin[x] = scenario.shape(x, y, z) ? 1 : 0;
    return;
  }
  for (uint32_t x = 0; x < volume.width; x += 8) {
    const uint32_t bits = input.byte();
    for (uint32_t i = x; i < x + 8 && i < volume.width; ++i)
      begin[i] = static_cast<uint8_t>(bits >> (i - x) & 1);
  }
}

// The way to push a row needs no byte of its own; most rows are pushed as samples.
Feed feed_of(uint32_t pattern, size_t row) {
  const uint32_t roll = (pattern + static_cast<uint32_t>(row) * 0x9E3779B1U) >> 24;
  if (pattern % 3 == 0 || roll < 128) return Feed::samples;
  return static_cast<Feed>(1 + roll % 4);
}

// A generated shape, and its size for slabs.
void read_shape(Input& input, Scenario& scenario) {
  const shapes::Below below = [&input](uint32_t limit) { return input.below(limit); };
  scenario.wide_size = shapes::draw_wide_size(below, 1000U << below(5));
  const auto kind = static_cast<shapes::Kind>(below(shapes::kinds));
  scenario.shape = shapes::draw_shape(kind, scenario.wide_size, below);
}

Scenario read_scenario(Input& input) {
  const uint32_t flags = input.byte();
  const bool is_shape = (flags & 0xB2) == 0x80;
  const Border border = (flags & 1) != 0 ? Border::open : Border::closed;
  // Sometimes a row longer than a word.
  const uint32_t width = (flags & 64) != 0 ? 29 + input.below(8) : 1 + input.below(9);
  Size size{width, 1 + input.below(8), input.below(max_slices)};
  // Few voxels, so that many volumes are tried: the reference is slow.
  size.depth = std::min(size.depth, 300 / (size.width * size.height));
  Scenario scenario{{size.width, size.height, border},
                    {},
                    false,
                    false,
                    false,
                    0,
                    0,
                    0,
                    {},
                    0,
                    BitVolume(size),
                    {},
                    {}};
  if (is_shape) read_shape(input, scenario);
  scenario.is_abandoned = (flags & 4) != 0;
  scenario.is_wide = (flags & 8) != 0;
  scenario.capacities = read_capacities(input, scenario.limits, scenario.is_wide);
  scenario.has_all_memory =
      holds_all(scenario.capacities, worst_case_capacities(scenario.limits, size.depth));
  scenario.chunk = 1 + input.byte();
  scenario.refusals = input.byte() % 200;
  scenario.refusal_seed = input.byte();
  const uint32_t pattern = input.word() * 2654435761U;
  size_t rows = size_t{size.height} * size.depth;
  if (scenario.is_abandoned && rows > 0) {
    // Rows that did not arrive are off, to the end of the current slice.
    rows = input.byte() % rows;
    scenario.last_samples = input.below(size.width);
  }
  const size_t fed_rows = rows + (scenario.last_samples > 0 ? 1 : 0);
  for (size_t row = 0; row < fed_rows; ++row) {
    const Feed feed = row < rows ? feed_of(pattern, row) : Feed::samples;
    scenario.feed.push_back(feed);
    read_row(input, scenario, row, feed);
  }
  if (scenario.is_abandoned) {
    scenario.volume.depth = static_cast<uint32_t>((fed_rows + size.height - 1) / size.height);
    scenario.volume.on.resize(scenario.volume.voxels());
    scenario.feed.resize(rows);
    for (uint32_t x = scenario.last_samples; scenario.last_samples > 0 && x < size.width; ++x)
      scenario.volume.on[rows * size.width + x] = 0;
  }
  return scenario;
}

template <class Scanner>
class Feeder {
 public:
  Feeder(Scanner& extractor, const Scenario& scenario)
      : extractor_(extractor), scenario_(scenario) {}

  void feed_all() {
    for (size_t row = 0; row < scenario_.feed.size(); ++row) feed_row(row);
    if (scenario_.last_samples == 0) return;
    push(scenario_.volume.on.data() + scenario_.feed.size() * scenario_.limits.width,
         scenario_.last_samples, 1);
  }

  void end() {
    for (bool is_first = true;; is_first = false) {
      // After an ending has begun, any call continues it.
      const Status status = !is_first && scenario_.chunk % 2 == 0 ? extractor_.resume()
                            : scenario_.is_abandoned              ? extractor_.abandon()
                                                                  : extractor_.finish();
      if (status == Status::ok) return;
      require(status == Status::suspended, to_string(status));
    }
  }

 private:
  void feed_row(size_t row) {
    const uint8_t* samples = scenario_.volume.on.data() + row * scenario_.limits.width;
    switch (scenario_.feed[row]) {
      case Feed::samples:
        return push(samples, scenario_.limits.width, 1);
      case Feed::strided:
        return push_strided(samples);
      case Feed::bits:
        return push_bits(samples);
      case Feed::skip_off:
        return whole_row([&] { return extractor_.skip_row(Substitute::off); });
      case Feed::skip_repeated:
        return whole_row([&] { return extractor_.skip_row(Substitute::previous_row); });
    }
  }

  template <class Sample>
  void push(const Sample* samples, uint32_t count, uint32_t stride) {
    for (uint32_t at = 0; at < count;) {
      const uint32_t part = scenario_.chunk < count - at ? scenario_.chunk : count - at;
      const PushResult pushed = extractor_.push(samples + at * stride, part, stride);
      require(pushed.status == Status::ok || pushed.status == Status::suspended,
              to_string(pushed.status));
      require(pushed.samples <= part, "push took more than it was given");
      at += pushed.samples;
    }
  }

  // Every third sample has another type; values between the samples would be on.
  void push_strided(const uint8_t* samples) {
    std::vector<int16_t> spread(size_t{3} * scenario_.limits.width - 2, INT16_MAX);
    for (size_t x = 0; x < scenario_.limits.width; ++x)
      spread[3 * x] = samples[x] != 0 ? int16_t{1} : INT16_MIN;
    push(spread.data(), scenario_.limits.width, 3);
  }

  void push_bits(const uint8_t* samples) {
    // Bits beyond the row are ignored.
    std::vector<uint8_t> bits((scenario_.limits.width + 7) / 8, 0xFF);
    for (size_t x = 0; x < scenario_.limits.width; ++x)
      if (samples[x] == 0) bits[x / 8] &= static_cast<uint8_t>(~(1U << x % 8));
    whole_row([&] { return extractor_.push_bits(bits.data()); });
  }

  template <class Call>
  void whole_row(Call call) {
    for (;;) {
      const PushResult pushed = call();
      require(pushed.status == Status::ok || pushed.status == Status::suspended,
              to_string(pushed.status));
      if (pushed.samples == scenario_.limits.width) return;
      require(pushed.status == Status::suspended, "a row was refused without a status");
    }
  }

  Scanner& extractor_;
  const Scenario& scenario_;
};

template <class Index, class Scanner = Extractor<Index>>
EventLog run(const Scenario& scenario, EventLog::Refuses refuses) {
  EventLog log(std::move(refuses));
  Block block(Extractor<Index>::bytes_for(scenario.limits, scenario.capacities),
              scenario.chunk % 2 == 0 ? Block::Kind::exact : Block::Kind::guarded);
  Scanner extractor;
  const Status started =
      extractor.start(scenario.limits, scenario.capacities, 1, block.memory(), make_sink(log));
  require(started == Status::ok, to_string(started));
  Feeder<Scanner> feeder(extractor, scenario);
  feeder.feed_all();
  feeder.end();
  require(collected(log.events).is_finished(), "the scan has no finish event");
  const Peaks most = extractor.peaks();
  const Capacities& room = scenario.capacities;
  // A HostExtractor has memory of its own.
  constexpr bool has_own_memory = std::is_base_of_v<HostExtractor, Scanner>;
  require(has_own_memory || (most.slots <= room.slots && most.holes <= room.holes),
          "more in use than there is room for");
  require(block.is_intact(), "a write outside the arena");
  return log;
}

// In arrays of exactly their size.
void check_ring(Incidence incidence, const Vertex& start, const std::vector<Run>& runs) {
  const auto count = static_cast<uint32_t>(runs.size());
  const int64_t area = twice_area(incidence, runs.data(), count);
  const auto links = static_cast<uint32_t>(link_count(runs.data(), count));
  std::vector<Vertex> vertices(links);
  ring_vertices(incidence, start, runs.data(), count, vertices.data());
  require(twice_area(incidence, vertices.data(), links) == area,
          "a chain and its vertices have different areas");
  struct Sum {
    Incidence incidence;
    int64_t area;
  } sum{incidence, 0};
  const RingSink sink{&sum, [](void* context, const Vertex* ring, uint32_t length) {
                        auto& to = *static_cast<Sum*>(context);
                        require(length >= 3, "a simple ring of fewer than three vertices");
                        const int64_t part = twice_area(to.incidence, ring, length);
                        require(part != 0, "a simple ring without an area");
                        to.area += part;
                        std::vector<Vertex> corners(ring, ring + length);
                        const uint32_t left = keep_corners(corners.data(), length);
                        require(twice_area(to.incidence, corners.data(), left) == part,
                                "corners alone have another area");
                      }};
  std::vector<uint32_t> scratch(size_t{2} * links);
  split_ring(vertices.data(), links, scratch.data(), sink);
  require(sum.area == area, "simple rings have another area than their ring");
}

void check_rings(const Events& events) {
  using Kind = Event::Kind;
  Vertex start{};
  std::vector<Run> runs;
  Incidence incidence = 0;
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    const bool is_ring = event.kind == Kind::ring;
    if ((is_ring || event.kind == Kind::region_end) && !runs.empty())
      check_ring(incidence, start, runs);
    if (event.kind != Kind::run) runs.clear();
    if (event.kind == Kind::run) runs.push_back(event.run);
    if (event.kind == Kind::region) incidence = event.incidence;
    if (is_ring) start = event.start;
  }
}

void check_surface(const Scenario& scenario, const Collector& collector) {
  const bool is_closed = scenario.limits.border == Border::closed;
  require(collector.was_abandoned() == scenario.is_abandoned,
          "the finish event has the wrong is_abandoned");
  require(collector.layers().size() == scenario.volume.depth, "another number of slices");
  require(collector.split_sides() == 0, "a straight side in more runs than it needs");
  const std::string miscount = miscounted(collector, scenario.volume, is_closed);
  require(miscount.empty(), miscount.c_str());
  const std::vector<Region> merged = merge(scenario.volume, is_closed);
  const std::string unlike = scenario.has_all_memory
                                 ? unlike_regions(collector.regions(), canonical(merged))
                                 : unlike_joined({collector}, merged);
  require(unlike.empty(), unlike.c_str());
  require(!scenario.has_all_memory || collector.loose().empty(), "loose, with memory left");
}

// A HostExtractor sends the events of an extractor with ample memory.
void check_host(const Scenario& scenario, const EventLog::Refuses& refuses) {
  Scenario large = scenario;
  large.capacities = {1 << 20, 1 << 20};
  const EventLog ample = run<uint32_t>(large, {});
  large.capacities = minimum_capacities();
  const EventLog host = run<uint32_t, HostExtractor>(large, refuses);
  require(host.events == ample.events, "a HostExtractor sends other events");
  const EventLog least = run<uint32_t, MinimumHost>(large, refuses);
  require(least.events == ample.events, "a HostExtractor with minimum sizes sends other events");
}

template <class Scanner>
std::vector<std::vector<uint64_t>> parts_of_slab(const BitVolume& volume, Border border,
                                                 uint32_t first, uint32_t end) {
  const Limits limits = limits_of_slab(volume, border, first, end);
  constexpr Capacities capacities{1 << 20, 1 << 12};
  EventLog log;
  Block block(Extractor32::bytes_for(limits, capacities));
  Scanner extractor;
  require_ok(extractor.start(limits, capacities, 1, block.memory(), make_sink(log)));
  push_all(extractor, voxels_of_slab(volume, first, end));
  finish_all(extractor);
  require(block.is_intact(), "a write outside the arena");
  return sorted_parts(log.events);
}

// The shape; otherwise copies of the volume side by side, so that many chains cross the seams.
BitVolume wide_volume(const Scenario& scenario) {
  const BitVolume& tile = scenario.volume;
  if (scenario.shape) return volume_of(scenario.wide_size, scenario.shape);
  return volume_of({60, 60, tile.depth}, [&](uint32_t x, uint32_t y, uint32_t z) {
    return tile.at(x % tile.width, y % tile.height, z);
  });
}

// Slow, so only for few inputs.
void check_slab(const Scenario& scenario) {
  if (scenario.refusal_seed % 16 != 0) return;
  const BitVolume volume = wide_volume(scenario);
  if (volume.depth == 0) return;
  const uint32_t first = scenario.refusal_seed / 16 % volume.depth;
  const uint32_t end = std::min(first + 1 + scenario.refusal_seed / 128, volume.depth);
  const Border border = scenario.limits.border;
  const auto parts = parts_of_slab<Extractor32>(volume, border, first, end);
  require(parts_of_slab<HostExtractor>(volume, border, first, end) == parts,
          "a host gives other parts of a slab");
  require(parts_of_slab<MinimumHost>(volume, border, first, end) == parts,
          "a host with the least room gives other parts of a slab");
}

void check(const Scenario& scenario) {
  const auto refuses = [&scenario](uint64_t offer) {
    const auto mixed =
        static_cast<uint32_t>(offer + 1) * 0x9E3779B1U * (2 * scenario.refusal_seed + 1);
    return (mixed >> 24) < scenario.refusals;
  };
  const EventLog log =
      scenario.is_wide ? run<uint32_t>(scenario, refuses) : run<uint16_t>(scenario, refuses);
  check_surface(scenario, collected(log.events));
  check_rings(log.events);
  check_host(scenario, refuses);
  check_slab(scenario);
  if (!detail::sizing::is_valid<uint16_t>(scenario.capacities)) return;
  Scenario plain = scenario;
  plain.chunk = 1 << 20;
  const EventLog other = scenario.is_wide ? run<uint16_t>(plain, {}) : run<uint32_t>(plain, {});
  require(other.events == log.events, "events depend on index width, portions or refusals");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  const Scenario scenario = read_scenario(input);
  try {
    check(scenario);
  } catch (const std::exception& error) {
    require(false, error.what());
  }
  return 0;
}
