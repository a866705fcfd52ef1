#include "trial.hpp"

#include <algorithm>
#include <discmc/encoder.hpp>

#include "extraction/extractors.hpp"
#include "require.hpp"
#include "slice_steps.hpp"

namespace discmc::command {
namespace {

constexpr ByteOutput discarding_output{
    nullptr, [](void*, const std::uint8_t*, std::size_t count) { return count; }};

DeviceWork work_of(const VolumeBits& volume, std::uint32_t slices, std::uint64_t steps,
                   std::uint64_t bytes) {
  const std::uint64_t rows = std::uint64_t{slices} * volume.limits().height;
  DeviceWork work;
  work.voxels = rows * volume.limits().width;
  work.on = volume.on(slices);
  work.rows = rows;
  work.steps = steps;
  work.bytes = bytes;
  return work;
}

// Pushes every row, and calls `call` after each slice.
template <class Scanner, class Call>
void push_all(Scanner& scanner, const VolumeBits& volume, Call call) {
  std::size_t row = 0;
  for (std::uint32_t z = 0; z < volume.slices(); ++z) {
    for (std::uint32_t y = 0; y < volume.limits().height; ++y)
      require(scanner.push_bits(volume.row(row++)).status);
    call(z + 1);
  }
  require(scanner.finish());
}

// Returns the total number of coded steps after each slice.
std::vector<std::uint64_t> steps_by_slice(const VolumeBits& volume,
                                          const SliceEncoderConfig& config) {
  const auto bytes = SliceEncoder::minimum_bytes(config);
  const auto memory = uninitialised(bytes);
  SliceSteps steps;
  steps.start(config.limits, config.key_slice_interval, {memory.get(), bytes});
  std::vector<std::uint64_t> counts;
  std::size_t row = 0;
  for (std::uint32_t z = 0; z < volume.slices(); ++z) {
    for (std::uint32_t y = 0; y < volume.limits().height; ++y) steps.push_bits(volume.row(row++));
    counts.push_back(steps.count());
  }
  return counts;
}

constexpr std::uint64_t step = 256;
constexpr std::uint32_t max_slots = detail::sizing::max_slots<std::uint16_t>;

// With this many unused slots, no loose fragment is ever sent (docs/memory.md).
constexpr std::uint32_t spare_slots = 1168;

std::uint64_t rounded_up(std::uint64_t bytes, std::uint64_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

std::uint64_t bytes_of_slots(const Limits& limits, std::uint32_t slots) {
  return Extractor16::bytes_for(limits, {std::min(slots, max_slots), 0});
}

}  // namespace

template <class Index>
Trial try_regions(const VolumeBits& volume, const Capacities& capacities) {
  const auto bytes = Extractor<Index>::bytes_for(volume.limits(), capacities);
  const auto memory = uninitialised(bytes);
  Encoder encoder;
  require(encoder.start(volume.header().label(), discarding_output));
  Extractor<Index> extractor;
  require(extractor.start(volume.limits(), capacities, volume.header().thresholds[0],
                          {memory.get(), bytes}, make_sink(encoder)));
  Trial trial;
  trial.memory = bytes;
  const auto work = [&] {
    const Statistics statistics = extractor.statistics();
    DeviceWork total = work_of(volume, extractor.slices(), statistics.links, encoder.bytes());
    total.cells = statistics.cells;
    return total;
  };
  push_all(extractor, volume, [&](std::uint32_t) { trial.slices.push_back(work()); });
  trial.peaks = extractor.peaks();
  trial.loose_pieces = extractor.statistics().fragments;
  trial.work = work();
  return trial;
}
template Trial try_regions<std::uint16_t>(const VolumeBits&, const Capacities&);
template Trial try_regions<std::uint32_t>(const VolumeBits&, const Capacities&);

Trial try_regions(const VolumeBits& volume, std::uint64_t arena_bytes) {
  Trial trial = try_regions<std::uint16_t>(
      volume, Extractor16::default_capacities(volume.limits(), arena_bytes));
  trial.memory = arena_bytes;
  return trial;
}

Trial try_slices(const VolumeBits& volume, std::uint32_t key_slice_interval) {
  const StreamHeader header = volume.header();
  const SliceEncoderConfig config{
      volume.limits(), {header.thresholds[0]}, key_slice_interval, 1, header.label()};
  Trial trial;
  trial.memory = SliceEncoder::minimum_bytes(config);
  const auto memory = uninitialised(trial.memory);
  SliceEncoder encoder;
  require(encoder.start(config, {memory.get(), trial.memory}, discarding_output));
  const std::vector<std::uint64_t> steps = steps_by_slice(volume, config);
  push_all(encoder, volume, [&](std::uint32_t slices) {
    trial.slices.push_back(work_of(volume, slices, steps[slices - 1], encoder.bytes()));
  });
  trial.work = work_of(volume, volume.slices(), steps.back(), encoder.bytes());
  return trial;
}

std::uint64_t max_arena_bytes(const Limits& limits) {
  return bytes_of_slots(limits, max_slots);
}

std::optional<Trial> min_without_loose_pieces(const VolumeBits& volume, const Trial& plenty,
                                              const std::function<void()>& done) {
  const auto has_none = [&](std::uint64_t steps, Trial& trial) {
    trial = try_regions(volume, steps * step);
    done();
    return trial.loose_pieces == 0;
  };
  const std::uint32_t used = plenty.peaks.slots;
  const Limits& limits = volume.limits();
  std::uint64_t end = rounded_up(bytes_of_slots(limits, used + spare_slots), step) / step;
  std::uint64_t begin = bytes_of_slots(limits, std::max(used, 1U) - 1) / step;
  Trial trial;
  if (!has_none(end, trial)) return std::nullopt;
  Trial smallest = trial;
  begin = std::max(begin, rounded_up(Extractor16::minimum_bytes(limits), step) / step - 1);
  while (end - begin > 1) {
    const std::uint64_t middle = begin + (end - begin) / 2;
    const bool is_enough = has_none(middle, trial);
    (is_enough ? end : begin) = middle;
    if (is_enough) smallest = trial;
  }
  return smallest;
}

std::vector<std::uint64_t> arena_sizes(const Limits& limits, std::uint64_t end) {
  const std::uint64_t min_bytes = Extractor16::minimum_bytes(limits);
  const std::uint64_t unit = min_bytes < 4096 ? step : 1024;
  std::vector<std::uint64_t> sizes;
  std::uint64_t size = min_bytes;
  // The sizes in quarters of the minimum are 4, 5, 6, 8, 12, 16, 24 and so on.
  for (std::uint64_t quarters = 5; size < end;) {
    if (sizes.empty() || size > sizes.back()) sizes.push_back(size);
    size = rounded_up(min_bytes * quarters / 4, unit);
    quarters = quarters == 5 ? 6 : quarters % 3 == 0 ? quarters / 3 * 4 : quarters / 2 * 3;
  }
  return sizes;
}

}  // namespace discmc::command
