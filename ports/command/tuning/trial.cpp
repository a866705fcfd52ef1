#include "trial.hpp"

#include <discmc/encoder.hpp>
#include <discmc/slice_encoder.hpp>

#include "extraction/extractors.hpp"
#include "require.hpp"
#include "slice_steps.hpp"

namespace discmc::command {
namespace {

constexpr ByteOutput nowhere{nullptr,
                             [](void*, const std::uint8_t*, std::size_t count) { return count; }};

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

// Pushes every row, and calls after every slice.
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

// Coded by the end of each slice, in all.
std::vector<std::uint64_t> steps_by_slice(const VolumeBits& volume,
                                          const SliceEncoderConfig& config) {
  const auto bytes = SliceEncoder::minimum_bytes(config);
  const auto memory = untouched(bytes);
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

}  // namespace

template <class Index>
Trial try_regions(const VolumeBits& volume, const Capacities& capacities) {
  const auto bytes = Extractor<Index>::bytes_for(volume.limits(), capacities);
  const auto memory = untouched(bytes);
  Encoder encoder;
  require(encoder.start(volume.header().label(), nowhere));
  Extractor<Index> extractor;
  require(extractor.start(volume.limits(), capacities, volume.header().thresholds[0],
                          {memory.get(), bytes}, make_sink(encoder)));
  Trial trial;
  trial.memory = bytes;
  const auto work = [&] {
    const Statistics statistics = extractor.statistics();
    DeviceWork done = work_of(volume, extractor.slices(), statistics.links, encoder.bytes());
    done.cells = statistics.cells;
    return done;
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
  const auto memory = untouched(trial.memory);
  SliceEncoder encoder;
  require(encoder.start(config, {memory.get(), trial.memory}, nowhere));
  const std::vector<std::uint64_t> steps = steps_by_slice(volume, config);
  push_all(encoder, volume, [&](std::uint32_t slices) {
    trial.slices.push_back(work_of(volume, slices, steps[slices - 1], encoder.bytes()));
  });
  trial.work = work_of(volume, volume.slices(), steps.back(), encoder.bytes());
  return trial;
}

}  // namespace discmc::command
