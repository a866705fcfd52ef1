// Joins many loose fragments in little memory: squares on thousands of planes, one fragment per
// side. The first sides of all squares come before the second ones, so no square closes before the
// last quarter. scripts/tools/bench-large runs it.
#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "streams/spilling_joiner.hpp"

namespace {

using discmc::Event;
using discmc::Vertex;
using discmc::command::SpillingJoiner;

constexpr discmc::Incidence upwards = discmc::incidence_of({0, 0, 1});
constexpr std::uint64_t columns = 128;
constexpr std::uint64_t squares_on_plane = columns * columns;

discmc::Direction direction_of_side(unsigned side) {
  const discmc::Direction first = discmc::direction_of(upwards, {2, 0, 0});
  return static_cast<discmc::Direction>((first + 2 * side) % discmc::direction_count(upwards));
}

Vertex corner(std::uint64_t square, unsigned side) {
  Vertex vertex{static_cast<std::int32_t>(4 * (square % columns)),
                static_cast<std::int32_t>(4 * (square / columns % columns)),
                static_cast<std::int32_t>(2 * (square / squares_on_plane))};
  for (unsigned i = 0; i < side; ++i) translate(vertex, upwards, direction_of_side(i), 1);
  return vertex;
}

void send_side(SpillingJoiner& joiner, std::uint64_t square, unsigned side) {
  Event event{};
  event.kind = Event::Kind::fragment;
  event.incidence = upwards;
  event.start = corner(square, side);
  event.incoming_direction = direction_of_side(side + 3);
  joiner.accept(event);
  event.kind = Event::Kind::run;
  event.run = discmc::Run::straight(direction_of_side(side), 1);
  joiner.accept(event);
  event.kind = Event::Kind::fragment_end;
  joiner.accept(event);
}

struct RegionCount {
  std::uint64_t regions = 0;
  discmc::SinkResult accept(const Event& event) {
    regions += event.kind == Event::Kind::region_end ? 1 : 0;
    return discmc::SinkResult::accepted;
  }
};

int join(std::uint64_t fragments, std::uint64_t bytes) {
  const std::uint64_t squares = fragments / 4;
  const auto begin = std::chrono::steady_clock::now();
  RegionCount count;
  SpillingJoiner joiner(discmc::make_sink(count), bytes);
  for (unsigned side = 0; side < 4; ++side)
    for (std::uint64_t square = 0; square < squares; ++square) send_side(joiner, square, side);
  joiner.finish();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%llu fragments, %llu regions: %.1f s, %ld MiB at most\n",
              static_cast<unsigned long long>(4 * squares),
              static_cast<unsigned long long>(count.regions), time.count(), usage.ru_maxrss / 1024);
  return count.regions == squares ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t fragments = argc == 3 ? std::strtoull(argv[1], nullptr, 10) : 0;
  const std::uint64_t mebibytes = argc == 3 ? std::strtoull(argv[2], nullptr, 10) : 0;
  if (fragments < 4 || mebibytes < 1) {
    std::fputs("usage: bench_join_fragments COUNT MEBIBYTES\n", stderr);
    return 2;
  }
  try {
    return join(fragments, mebibytes << 20);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_join_fragments: %s\n", error.what());
    return 1;
  }
}
