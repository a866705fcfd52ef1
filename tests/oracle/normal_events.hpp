// Events with normals, taken apart, and the normals that they should have.
#ifndef DISCMC_TESTS_NORMAL_EVENTS_HPP
#define DISCMC_TESTS_NORMAL_EVENTS_HPP

#include <discmc/normal.hpp>
#include <map>
#include <vector>

#include "gradient.hpp"
#include "stream.hpp"

namespace discmc::test {

/// Of voxels that are no cubes; the y axis is mirrored.
constexpr int32_t uneven_spacing[3] = {700, -1000, 1500};

/// A run and the normal where it starts; a fragment's first run has that of its stand-in.
struct Side {
  Run run;
  OctahedralNormal normal;
};

/// Puts spilled fragments back and calls visit(vertex, normal) where a run or a stand-in starts.
template <class Visit>
void for_each_start(const Events& events, Visit visit) {
  std::map<uint32_t, std::vector<Side>> fragments;
  std::vector<Side> sides;
  Incidence incidence = 0;
  uint32_t number = 0;
  Vertex vertex{0, 0, 0};
  const auto end_ring = [&] {
    std::vector<Side> waiting(sides.rbegin(), sides.rend());
    while (!waiting.empty()) {
      const Side side = waiting.back();
      waiting.pop_back();
      visit(vertex, side.normal);
      if (side.run.is_fragment()) {
        std::vector<Side> inside = fragments.at(side.run.fragment_number());
        if (inside.front().normal.is_none()) inside.front().normal = side.normal;
        waiting.insert(waiting.end(), inside.rbegin(), inside.rend());
        continue;
      }
      const Vertex step = direction_vector(incidence, side.run.direction());
      for (uint32_t i = 0; i < side.run.length(); ++i) vertex = vertex + step;
    }
    sides.clear();
  };
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    switch (event.kind) {
      case Event::Kind::region:
        incidence = event.incidence;
        break;
      case Event::Kind::ring:
        end_ring();
        vertex = event.start;
        break;
      case Event::Kind::run:
        sides.push_back({event.run, event.normal});
        break;
      case Event::Kind::region_end:
        end_ring();
        break;
      case Event::Kind::fragment:
        number = event.number;
        break;
      case Event::Kind::fragment_end:
        fragments[number] = sides;
        sides.clear();
        break;
      default:
        break;
    }
  }
}

inline Events without_normals(const Events& events) {
  Events plain;
  for (const RecordedEvent& recorded : events) {
    Event event = recorded.event();
    event.normal = {0, 0};
    plain.emplace_back(event);
  }
  return plain;
}

/// The normal of a second pass, from the definition of the gradient.
template <class Sample>
OctahedralNormal reference_normal(const reference::SampleVolume<Sample>& volume,
                                  const Vertex& vertex) {
  const std::array<double, 3> up = reference::gradient(volume, vertex);
  // Sixteenths at the finest, so this is exact.
  const LongVector down = {static_cast<int64_t>(-16 * up[0]), static_cast<int64_t>(-16 * up[1]),
                           static_cast<int64_t>(-16 * up[2])};
  return octahedral_normal(weighted(down, axis_weights(uneven_spacing)));
}

}  // namespace discmc::test

#endif
