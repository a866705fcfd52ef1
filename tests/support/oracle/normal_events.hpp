// Splits events with normals, and computes the expected normals.
#pragma once

#include <discmc/normal_extractor.hpp>
#include <vector>

#include "gradient.hpp"
#include "stream.hpp"

namespace discmc::test {

/// The extractor that keeps the samples for such normals, or for none.
template <class Index, class Normals>
struct ExtractorOf {
  using Type = Extractor<Index>;
};
template <class Index, class Sample>
struct ExtractorOf<Index, detail::trace::GradientIntake<Sample>> {
  using Type = NormalExtractor<Index, Sample>;
};

/// A spacing of anisotropic voxels with a mirrored y axis.
constexpr int32_t uneven_spacing[3] = {700, -1000, 1500};

/// Calls visit(vertex, normal, is_corner) for each start of a run. A loose fragment may begin with
/// the rest of a side, which starts at no corner and has no normal.
template <class Visit>
void for_each_start(const Events& events, Visit visit) {
  Incidence incidence = 0;
  Vertex vertex{0, 0, 0};
  bool is_begun = false;  // whether the fragment has begun and has no run yet
  Direction came = 0;
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    switch (event.kind) {
      case Event::Kind::region:
        incidence = event.incidence;
        break;
      case Event::Kind::fragment:
        incidence = event.incidence;
        vertex = event.start;
        is_begun = true;
        came = event.incoming_direction;
        break;
      case Event::Kind::ring:
        vertex = event.start;
        break;
      case Event::Kind::run:
        visit(vertex, event.normal, !is_begun || event.run.direction() != came);
        is_begun = false;
        vertex = vertex + displacement(incidence, &event.run, 1);
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

/// Returns the normal of a second pass, by the definition of the gradient.
template <class Sample>
OctahedralNormal reference_normal(const reference::SampleVolume<Sample>& volume,
                                  const Vertex& vertex) {
  const std::array<double, 3> up = reference::gradient(volume, vertex);
  // The result is exact, because gradients are multiples of a sixteenth.
  const LongVector down = {static_cast<int64_t>(-16 * up[0]), static_cast<int64_t>(-16 * up[1]),
                           static_cast<int64_t>(-16 * up[2])};
  return octahedral_normal(weighted(down, axis_weights(uneven_spacing)));
}

}  // namespace discmc::test
