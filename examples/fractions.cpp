// Both ends of a stream of slices with fractions. The scanner sends a ball. The receiver prints how
// far its crossings of the surface are from the true ball, in voxels: from midpoints 0.16, from
// fractions 0.05. Your receiver moves each vertex from edge_midpoint() to the crossing.
#include <cmath>
#include <cstdio>
#include <discmc/fraction.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/receiver.hpp>

using namespace discmc;

constexpr uint32_t size = 48;
constexpr SliceEncoderConfig config{{size, size}, {128}, 16, 1, {}, 4};

// Positive inside the ball.
static double depth(double x, double y, double z) {
  return 20.3 - std::hypot(x - 23.5, y - 23.5, z - 23.5);
}

struct Comparison {
  SinkResult accept(const Event& event) {
    if (event.kind != Event::Kind::fractions) return SinkResult::accepted;
    for (uint32_t x = 0; x < size; ++x)
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t eighths = fraction_of(event.fractions[x], axis);
        if (eighths == 0) continue;
        double at[] = {double(x), double(event.row), double(event.slice)};
        at[axis] += eighths / 8.0 - 1;
        fractions += std::abs(depth(at[0], at[1], at[2]));
        at[axis] += 0.5 - eighths / 8.0;
        midpoints += std::abs(depth(at[0], at[1], at[2]));
        ++crossings;
      }
    return SinkResult::accepted;
  }
  double fractions = 0, midpoints = 0;
  int crossings = 0;
} comparison;

int main() {
  static uint8_t sender_memory[FractionSliceEncoder<uint8_t>::minimum_bytes(config)];
  static uint8_t receiver_memory[Receiver::minimum_bytes(config.limits, 1, config.levels)];
  static FractionSliceEncoder<uint8_t> sender;
  static Receiver receiver;
  const ByteOutput link{&receiver, [](void* context, const uint8_t* bytes, size_t count) {
                          return static_cast<Receiver*>(context)->push(bytes, count).bytes;
                        }};
  bool good = receiver.start(memory_of(receiver_memory), make_sink(comparison)) == Status::ok &&
              sender.start(config, memory_of(sender_memory), link) == Status::ok;
  for (uint32_t i = 0; good && i < size * size * size; ++i) {
    const double sample = 127.5 + 20 * depth(i % size, i / size % size, i / size / size);
    const auto byte = static_cast<uint8_t>(std::fmin(std::fmax(sample, 0), 255));
    good = sender.push(&byte, 1).status == Status::ok;
  }
  good = good && sender.finish() == Status::ok;
  const double midpoints = comparison.midpoints / comparison.crossings;
  const double fractions = comparison.fractions / comparison.crossings;
  std::printf("from midpoints %.2f, from fractions %.2f\n", midpoints, fractions);
  return good && 3 * fractions < midpoints ? 0 : 1;
}
