// Encodes the same volumes as regions and as slices. Counts the instructions, and prints the
// results. The streams need a larger board than those of work.cpp.
#include "counted_streams.hpp"
#include "tuning/slice_steps.hpp"

using namespace discmc;
using namespace discmc::test;

// ---- volumes ----

// The first slices of random({64, 64, 64}, 128, 1) of the oracle: SplitMix64.
class RowsOfNoise {
 public:
  void read(uint8_t* row) {
    for (uint32_t x = 0; x < 64; ++x) row[x] = next() >> 63 == 0 ? UINT8_MAX : 0;
  }

 private:
  uint64_t next() {
    state_ += 0x9E3779B97F4A7C15;
    uint64_t mixed = (state_ ^ (state_ >> 30)) * 0xBF58476D1CE4E5B9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
    return mixed ^ (mixed >> 31);
  }
  uint64_t state_ = 1;
};

constexpr Volume small_ball{ball, ball.width, threshold};
constexpr Volume noise{{64, 64}, 16, threshold};

// ---- steps ----

// Counts the coded voxels and runs of a volume.
template <class Rows>
static uint32_t steps(const Volume& volume, Rows samples) {
  command::SliceSteps steps;
  steps.start(volume.limits, 0, memory_of(memory));
  for (uint32_t row = 0; row < volume.limits.height * volume.slices; ++row) {
    uint8_t samples_of_row[64];
    samples.read(samples_of_row);
    steps.push(samples_of_row, volume.threshold);
  }
  return static_cast<uint32_t>(steps.count());
}

int main() {
  const bool good =
      count_slices<uint8_t>("empty_as_ball", small_ball, 0, RowsOf{outside, ball}) &&
      count_slices<uint8_t>("ball", small_ball, 0, RowsOf{inside_ball, ball}) &&
      count_slices<uint8_t>("empty_as_noise", noise, 0, RowsOf{outside, noise.limits}) &&
      count_kinds<uint8_t, RowsOfNoise>("noise", noise);
  board::report("arena", sizeof memory);
  board::report("steps_of_ball", steps(small_ball, RowsOf{inside_ball, ball}));
  board::report("rows_of_ball", ball.height * small_ball.slices);
  board::report("steps_of_noise", steps(noise, RowsOfNoise{}));
  board::report("rows_of_noise", noise.limits.height * noise.slices);
  board::report("voxels_of_noise", noise.voxels());
  board::stop(good);
}
