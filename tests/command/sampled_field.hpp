// Volumes of samples from a formula, and their interpolated surfaces.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "extraction/classic.hpp"
#include "extraction/crossings.hpp"
#include "extraction/extraction.hpp"
#include "meshes/intersections.hpp"
#include "meshes/mesh.hpp"
#include "oracle/stream.hpp"
#include "sample_reader.hpp"

namespace sampled_field {

using namespace discmc::command;
using discmc::Border;
using discmc::Vertex;
using discmc::reference::Size;
using sample_reader::SampleReader;

/// Samples from 0 to 100.
struct Field {
  Size size;
  std::vector<int> samples;

  int at(int x, int y, int z) const {
    const auto row = static_cast<std::size_t>(z) * size.height + static_cast<std::size_t>(y);
    return samples.at(row * size.width + static_cast<std::size_t>(x));
  }
};

constexpr double threshold = 50;
/// A level that whole numbers do not reach exactly.
constexpr double level = 49.5;

inline Field field_of(Size size, const std::function<double(double, double, double)>& value) {
  Field field{size, {}};
  for (std::uint32_t z = 0; z < size.depth; ++z)
    for (std::uint32_t y = 0; y < size.height; ++y)
      for (std::uint32_t x = 0; x < size.width; ++x)
        field.samples.push_back(
            static_cast<int>(std::lround(std::fmin(std::fmax(value(x, y, z), 0), 100))));
  return field;
}

inline Field noise(Size size, std::uint32_t seed) {
  discmc::test::Chance chance(seed);
  return field_of(size, [&](double, double, double) { return chance.below(101); });
}

/// Denser towards its middle.
inline Field ball(std::uint32_t size, double radius, double steepness = 8) {
  const double middle = (size - 1) / 2.0;
  return field_of({size, size, size}, [=](double x, double y, double z) {
    return level + steepness * (radius - std::hypot(x - middle, y - middle, z - middle));
  });
}

struct Extracted {
  Surface surface;
  CrossingFinder finder;
};

inline Extracted extracted(const Field& field, SampleType type = SampleType::u8,
                           const Point& spacing_mm = {1, 1, 1}, Border border = Border::closed) {
  SampleReader reader(field.size, field.samples, spacing_mm, type);
  // The surface interpolated between the same samples, of any type.
  const Selection selection{is_floating(type) ? level : threshold};
  SurfaceBuilder builder;
  Extracted result{{}, CrossingFinder(reader.info(), selection)};
  extract(reader, {selection, border}, {{selection, discmc::make_sink(builder), &result.finder}});
  result.surface = std::move(builder.surface());
  result.surface.spacing_mm = spacing_mm;
  return result;
}

inline FaceMesh interpolated(const Extracted& extracted, double tolerance) {
  return build_mesh(extracted.surface,
                    {true, Faces::triangles, &extracted.finder.crossings(), tolerance});
}

inline std::size_t crossing_pairs(const FaceMesh& mesh) {
  return intersecting_faces(mesh, all_faces(mesh)).size();
}

inline FaceMesh classic(const Field& field) {
  SampleReader reader(field.size, field.samples);
  return classic_mesh(reader, {{threshold}, Border::closed});
}

}  // namespace sampled_field
