// The work of regions and of slices side by side, whose instructions are counted, and its results.
// The volumes need a larger board than those of work.cpp.
//
// The CT head is read from the file volume.raw, rows of 256 samples of 16 bits. Without it, the
// rest is done.
#include <board.hpp>
#include <discmc/encoder.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/slice_encoder.hpp>
#include <semihosting.hpp>

#include "scans.hpp"
#include "tuning/slice_steps.hpp"

using namespace discmc;
using namespace discmc::test;

// The arena that payloads.cpp has, too: the streams of the head are the same.
alignas(4) static uint8_t memory[88 * 1024];
static Extractor16 extractor;
static Encoder encoder;
static SliceEncoder slice_encoder;
static FractionSliceEncoder<uint16_t> fraction_encoder;

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

class RowsOfFile {
 public:
  RowsOfFile() : file_(semihosting::open_to_read("volume.raw")) {}
  bool is_open() const { return file_ >= 0; }
  // A row that is not there makes a stream of another length.
  void read(uint16_t* row) { semihosting::read(file_, row, 256 * sizeof *row); }

 private:
  intptr_t file_;
};

// ---- counted scans ----

struct Volume {
  Limits limits;
  uint32_t slices;
  int32_t threshold;

  StreamHeader header() const { return {limits.width, limits.height, slices, {}, threshold}; }
};
constexpr Volume small_ball{ball, ball.width, threshold};
constexpr Volume noise{{64, 64}, 16, threshold};
constexpr Volume head{{256, 256}, 113, 500};

template <class Sample, class Rows>
static bool tell_regions(const char* name, const Volume& volume, Rows rows) {
  const bool good = encoder.start(volume.header().label(), {nullptr, take_bytes}) == Status::ok &&
                    extractor.start(volume.limits, volume.threshold, memory_of(memory),
                                    make_sink(encoder)) == Status::ok &&
                    push_and_finish<Sample>(extractor, volume.limits, volume.slices, rows);
  board::report(name, static_cast<uint32_t>(encoder.bytes()));
  return good;
}

template <class Sample, class SomeSliceEncoder, class Rows>
static bool tell_slices(const char* name, SomeSliceEncoder& slices, const Volume& volume,
                        uint32_t interval, uint8_t levels, Rows rows) {
  const SliceEncoderConfig config{volume.limits, {volume.threshold}, interval, 1, {volume.slices},
                                  levels};
  const bool good = slices.start(config, memory_of(memory), {nullptr, take_bytes}) == Status::ok &&
                    push_and_finish<Sample>(slices, volume.limits, volume.slices, rows);
  board::report(name, static_cast<uint32_t>(slices.bytes()));
  return good;
}
template <class Sample, class Rows>
static bool tell_slices(const char* name, const Volume& volume, uint32_t interval, Rows rows) {
  return tell_slices<Sample>(name, slice_encoder, volume, interval, 0, rows);
}

// In this order payloads.awk reads the counts.
template <class Sample, class Rows>
static bool tell_both(const char* name, const Volume& volume) {
  return tell_regions<Sample>(name, volume, Rows{}) &&
         tell_slices<Sample>(name, volume, 0, Rows{}) &&
         tell_slices<Sample>(name, volume, 16, Rows{}) &&
         tell_slices<Sample>(name, volume, 1, Rows{});
}

static bool tell_fractions(const char* name, const Volume& volume, uint8_t levels) {
  return tell_slices<uint16_t>(name, fraction_encoder, volume, 0, levels, RowsOfFile{});
}

// ---- steps ----

// The coded voxels and runs of a volume.
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
  const auto tell_once = [](const char* name, const Volume& volume, auto rows) {
    return tell_slices<uint8_t>(name, volume, {0}, rows);
  };
  bool good = tell_once("empty_as_ball", small_ball, RowsOf{outside, ball}) &&
              tell_once("ball", small_ball, RowsOf{inside_ball, ball}) &&
              tell_once("empty_as_noise", noise, RowsOf{outside, noise.limits}) &&
              tell_both<uint8_t, RowsOfNoise>("noise", noise);
  if (good && RowsOfFile().is_open())
    good = tell_both<uint16_t, RowsOfFile>("head", head) &&
           tell_fractions("head_fractions", head, 2) && tell_fractions("head_fractions", head, 4);
  board::report("arena", sizeof memory);
  board::report("steps_of_ball", steps(small_ball, RowsOf{inside_ball, ball}));
  board::report("rows_of_ball", ball.height * small_ball.slices);
  board::report("steps_of_noise", steps(noise, RowsOfNoise{}));
  board::report("rows_of_noise", noise.limits.height * noise.slices);
  board::report("voxels_of_noise", 64 * 64 * noise.slices);
  board::report("voxels_of_head", 256 * 256 * head.slices);
  board::stop(good);
}
