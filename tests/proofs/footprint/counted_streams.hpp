// Encodes streams of a volume as on a device, with their instructions counted.
#pragma once

#include <board.hpp>
#include <discmc/encoder.hpp>
#include <discmc/slice_encoder.hpp>

#include "scans.hpp"

namespace discmc::test {

/// The arena is as large as in payloads.cpp, so the streams are equal.
alignas(4) inline uint8_t memory[88 * 1024];

struct Volume {
  Limits limits;
  uint32_t slices;
  int32_t threshold;

  StreamHeader header() const { return {limits.width, limits.height, slices, {}, threshold}; }
  uint32_t voxels() const { return limits.width * limits.height * slices; }
};

/// Rows: RowsOf, or a class with the same read(). Reports the bytes of the stream.
template <class Sample, class Rows>
bool count_regions(const char* name, const Volume& volume, Rows rows) {
  static Extractor16 extractor;
  static Encoder encoder;
  const bool good =
      encoder.start(volume.header().label(), {nullptr, discard_bytes}) == Status::ok &&
      extractor.start(volume.limits, volume.threshold, memory_of(memory), make_sink(encoder)) ==
          Status::ok &&
      push_and_finish<Sample>(extractor, volume.limits, volume.slices, rows);
  board::report(name, static_cast<uint32_t>(encoder.bytes()));
  return good;
}

/// SomeSliceEncoder: SliceEncoder, or FractionSliceEncoder for streams with levels.
template <class Sample, class SomeSliceEncoder = SliceEncoder, class Rows>
bool count_slices(const char* name, const Volume& volume, uint32_t key_slice_interval, Rows rows,
                  uint8_t levels = 0) {
  static SomeSliceEncoder encoder;
  const SliceEncoderConfig config{
      volume.limits, {volume.threshold}, key_slice_interval, 1, {volume.slices}, levels};
  const bool good =
      encoder.start(config, memory_of(memory), {nullptr, discard_bytes}) == Status::ok &&
      push_and_finish<Sample>(encoder, volume.limits, volume.slices, rows);
  board::report(name, static_cast<uint32_t>(encoder.bytes()));
  return good;
}

/// Rows: constructed once per stream. payloads.awk reads the counts in this order.
template <class Sample, class Rows>
bool count_kinds(const char* name, const Volume& volume) {
  return count_regions<Sample>(name, volume, Rows{}) &&
         count_slices<Sample>(name, volume, 0, Rows{}) &&
         count_slices<Sample>(name, volume, 16, Rows{}) &&
         count_slices<Sample>(name, volume, 1, Rows{});
}

}  // namespace discmc::test
