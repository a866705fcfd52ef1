// The work of the stages before the extractor. count_front_end counts its instructions. Each report
// is the divisor of the previous count: samples, voxels or rows.
#include <board.hpp>
#include <discmc/discmc.hpp>

#include "marks.hpp"

using namespace discmc;

namespace {

constexpr uint32_t width = 256, height = 8, rows = 32;
constexpr Limits limits{width, height};

uint8_t memory[4096];
alignas(4) uint8_t bytes[2 * width], dark[2 * width];
uint8_t bits[width / 8];
uint16_t samples[width];
int16_t offsets[width];

uint8_t noise() {
  static uint32_t state = 1;
  state = state * 1664525 + 1013904223;
  return static_cast<uint8_t>(state >> 24);
}

template <class Work>
void count(const char* name, uint32_t units, uint32_t times, Work work) {
  for (uint32_t i = 0; i < times; ++i) {
    for (uint8_t& byte : bits) byte = noise();
    count_on();
    work();
    count_off();
  }
  count_report();
  board::report(name, units * times);
}

void count_unpacking() {
  const auto unpacked = [](const char* name, Packing packing) {
    count(name, width, 1, [packing] { unpack(packing, bytes, width, samples); });
  };
  unpacked("unpack_raw10", Packing::raw10);
  unpacked("unpack_raw12", Packing::raw12);
  unpacked("unpack_mono10p", Packing::mono10p);
  unpacked("unpack_mono12p", Packing::mono12p);
  unpacked("unpack_mono10pmsb", Packing::mono10pmsb);
  unpacked("unpack_mono12pmsb", Packing::mono12pmsb);
  unpacked("unpack_mono12_packed", Packing::mono12_packed);
}

void count_thresholds() {
  const auto* const wide = reinterpret_cast<const uint16_t*>(bytes);
  count("threshold_row_noise_8_bits", width, 1, [] { threshold_row(bytes, width, 128, bits); });
  count("threshold_row_noise_16_bits", width, 1,
        [wide] { threshold_row(wide, width, 30000, bits); });
  count("threshold_row_off_8_bits", width, 1, [] { threshold_row(dark, width, 128, bits); });
  count("threshold_row_less", width, 1,
        [] { threshold_row_less(bytes, offsets, width, 128, bits); });
}

bool count_filters() {
  static MajorityFilter filter;
  static Downsampler<uint8_t> means;
  static RowCropper cropper;
  if (filter.start(limits, memory_of(memory)) != Status::ok) return false;
  // From the second row on, each call also processes the row that is due.
  for (uint32_t row = 0; row <= height; ++row) (void)filter.push(bits);
  count("majority_filter", width, rows, [] { (void)filter.push(bits); });
  if (means.start(limits, 2, memory_of(memory)) != Status::ok) return false;
  count("block_means_of_2", width, rows, [] { (void)means.push(bytes); });
  if (cropper.start(limits, {}, {}, {}) != Status::ok) return false;
  count("row_picker_a_row", 1, rows, [] { (void)cropper.next(); });
  count("crop_bits", width, 1, [] { cropper.crop_bits(bytes, bits); });
  return true;
}

bool count_ring() {
  static RowRing ring;
  if (ring.start(16, rows, memory_of(memory)) != Status::ok) return false;
  count("row_ring_a_row_filled", 1, rows, [] {
    if (ring.free_row() != nullptr) ring.commit();
  });
  count("row_ring_a_row_taken", 1, rows, [] {
    if (ring.peek() == RowRing::Next::ready) ring.pop();
  });
  return ring.consumed() == rows;
}

}  // namespace

int main() {
  for (uint8_t& byte : bytes) byte = noise();
  count_unpacking();
  count_thresholds();
  board::stop(count_filters() && count_ring());
}
