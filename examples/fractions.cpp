// Both ends of a stream of slices with fractions. The scanner sends a ball. The receiver compares
// where the surface crosses the edges between voxels with the true ball, in voxels:
//
//   from midpoints 0.16, from fractions 0.05
//
// A receiver of your own moves each vertex of a polygon from edge_midpoint() to that place.
#include <cmath>
#include <cstdio>
#include <discmc/fraction.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/receiver.hpp>

using namespace discmc;

constexpr uint32_t size = 48;
constexpr double radius = 20.3;
constexpr SliceEncoderConfig config{{size, size}, {128}, 16, 1, {}, 4};

static double distance_to_centre(double x, double y, double z) {
  constexpr double centre = (size - 1) / 2.0;
  return std::hypot(x - centre, y - centre, z - centre);
}

struct Comparison {
  SinkResult accept(const Event& event) {
    if (event.kind != Event::Kind::fractions) return SinkResult::accepted;
    for (uint32_t x = 0; x < size; ++x)
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t eighths = fraction_of(event.fractions[x], axis);
        if (eighths == 0) continue;
        double at[] = {double(x), double(event.row), double(event.slice)};
        at[axis] += -1 + eighths / 8.0;
        fractions += std::abs(distance_to_centre(at[0], at[1], at[2]) - radius);
        at[axis] += 0.5 - eighths / 8.0;
        midpoints += std::abs(distance_to_centre(at[0], at[1], at[2]) - radius);
        ++crossings;
      }
    return SinkResult::accepted;
  }
  double fractions = 0, midpoints = 0;
  int crossings = 0;
};

int main() {
  static uint8_t sender_memory[FractionSliceEncoder<uint8_t>::minimum_bytes(config)];
  static uint8_t receiver_memory[Receiver::minimum_bytes(config.limits, 1, config.levels)];
  static FractionSliceEncoder<uint8_t> sender;
  static Receiver receiver;
  Comparison comparison;
  const ByteOutput link{&receiver, [](void* context, const uint8_t* bytes, size_t count) {
                          return static_cast<Receiver*>(context)->push(bytes, count).bytes;
                        }};
  bool good = receiver.start(memory_of(receiver_memory), make_sink(comparison)) == Status::ok &&
              sender.start(config, memory_of(sender_memory), link) == Status::ok;
  for (uint32_t z = 0; good && z < size; ++z)
    for (uint32_t y = 0; good && y < size; ++y) {
      uint8_t row[size];
      for (uint32_t x = 0; x < size; ++x) {
        const double depth = 20 * (radius - distance_to_centre(x, y, z));
        row[x] = static_cast<uint8_t>(std::fmin(std::fmax(127.5 + depth, 0), 255));
      }
      good = sender.push(row, size).status == Status::ok;
    }
  good = good && sender.finish() == Status::ok;
  std::printf("from midpoints %.2f, from fractions %.2f\n",
              comparison.midpoints / comparison.crossings,
              comparison.fractions / comparison.crossings);
  return good && 3 * comparison.fractions < comparison.midpoints ? 0 : 1;
}
