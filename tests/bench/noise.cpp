// The cost of noise in streams, and its reduction by the stages before the extractor: the table of
// docs/front-end.md, on generated volumes.
//
//   bench_noise

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include <discmc/discmc.hpp>

using namespace discmc;

namespace {

constexpr uint32_t extent = 100;
constexpr Limits limits{extent, extent};
constexpr double radius = 40, noise = 20;
constexpr int32_t threshold = 128;
constexpr size_t row_bytes = (extent + 7) / 8;

// Rows of bits, each of row_bytes.
using Rows = std::vector<std::vector<uint8_t>>;

size_t count_bytes(void* count, const uint8_t*, size_t bytes) {
  *static_cast<size_t*>(count) += bytes;
  return bytes;
}

void require(Status status) {
  if (status == Status::ok) return;
  std::fprintf(stderr, "bench_noise: %s\n", to_string(status));
  std::exit(1);
}

struct Streams {
  uint64_t polygons;
  size_t regions = 0, slices = 0;  // bytes
};

Streams streams_of(const Rows& rows) {
  std::vector<uint8_t> memory(64 << 20);
  const Memory all{memory.data(), memory.size()};
  Streams streams{};
  Encoder encoder;
  Extractor32 extractor;
  require(encoder.start({extent}, {&streams.regions, count_bytes}));
  require(extractor.start(limits, threshold, all, make_sink(encoder)));
  for (const auto& row : rows) require(extractor.push_bits(row.data()).status);
  require(extractor.finish());
  streams.polygons = extractor.statistics().regions;

  SliceEncoder slices;
  require(slices.start({{extent, extent}}, all, {&streams.slices, count_bytes}));
  for (const auto& row : rows) require(slices.push_bits(row.data()).status);
  require(slices.finish());
  return streams;
}

Rows filtered(const Rows& rows) {
  std::vector<uint8_t> memory(MajorityFilter::bytes_for(limits));
  MajorityFilter filter;
  require(filter.start(limits, {memory.data(), memory.size()}));
  Rows result;
  for (const auto& row : rows)
    if (const uint8_t* due = filter.push(row.data())) result.emplace_back(due, due + row_bytes);
  while (const uint8_t* due = filter.drain()) result.emplace_back(due, due + row_bytes);
  return result;
}

// A ball with a gradient at its surface: the samples change by `slope` per voxel between two
// values.
struct Ball {
  double fades_by, least, most;
};

Rows scanned(const Ball& ball, double deviation) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1);
  Rows rows;
  std::vector<uint8_t> samples(extent), bits(row_bytes);
  for (uint32_t i = 0; i < extent * extent; ++i) {
    for (uint32_t x = 0; x < extent; ++x) {
      constexpr double middle = (extent - 1) / 2.0;
      const double from = std::hypot(x - middle, i % extent - middle, i / extent - middle);
      const double value =
          std::fmin(std::fmax(threshold + ball.fades_by * (radius - from), ball.least), ball.most);
      const double noisy = deviation > 0 ? value + deviation * normal(random) : value;
      samples[x] = static_cast<uint8_t>(std::fmin(std::fmax(std::floor(noisy + 0.5), 0), 255));
    }
    threshold_row(samples.data(), extent, threshold, bits.data());
    rows.push_back(bits);
  }
  return rows;
}

void print(const char* name, const Rows& rows) {
  const Streams streams = streams_of(rows);
  std::printf("| %-27s | %7llu | %7zu | %6zu |\n", name,
              static_cast<unsigned long long>(streams.polygons), streams.regions, streams.slices);
}

void print_table(const char* name, const Ball& ball) {
  std::printf("%s\n\n| | polygons | regions | slices |\n|---|--:|--:|--:|\n", name);
  print("without noise", scanned(ball, 0));
  Rows rows = scanned(ball, noise);
  print("with noise", rows);
  for (const char* filters : {"one filter", "two filters", "three filters"}) {
    rows = filtered(rows);
    print(filters, rows);
  }
  std::printf("\n");
}

}  // namespace

int main() {
  print_table("fades by 8 a voxel", {8, 0, 255});
  print_table("hard edge, 98 beside 158", {1e9, 98, 158});
  print_table("hard edge, 60 beside 200", {1e9, 60, 200});
}
