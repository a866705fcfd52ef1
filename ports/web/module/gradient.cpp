#include "gradient.hpp"

#include <cstdint>
#include <discmc/sample_window.hpp>
#include <memory>

#include "extraction/narrowed_volume.hpp"
#include "require.hpp"
#include "samples/sample_bounds.hpp"
#include "samples/spacing.hpp"

namespace discmc::web {
namespace {

// The numbers of all vertices, lowest first. Sorted by counting, because there are few heights.
std::vector<std::uint32_t> upwards(const std::vector<DrawnVertex>& vertices, std::uint32_t slices) {
  constexpr std::int32_t lowest = -1;
  std::vector<std::uint32_t> begin(2 * std::size_t{slices} + 2);
  for (const DrawnVertex& vertex : vertices)
    ++begin[static_cast<std::size_t>(vertex.z - lowest) + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<std::uint32_t> order(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    order[begin[static_cast<std::size_t>(vertices[i].z - lowest)]++] = i;
  return order;
}

template <class Sample>
void set_from_samples(meshing::SliceReader& volume, const std::vector<DrawnVertex>& vertices,
                      std::vector<OctahedralNormal>& normals) {
  const meshing::SampleGrid& info = volume.info();
  const Limits limits{info.dims[0], info.dims[1]};
  std::vector<std::uint8_t> memory(SampleWindow<Sample>::bytes_for(limits));
  SampleWindow<Sample> window;
  meshing::require(window.start(limits, {memory.data(), memory.size()}));
  const auto spacing = meshing::spacing_nm(info.spacing_mm);
  const AxisWeights weights = axis_weights({spacing[0], spacing[1], spacing[2]});
  const std::vector<std::uint32_t> order = upwards(vertices, info.dims[2]);
  auto next = order.begin();
  const auto set_covered = [&] {
    for (; next != order.end(); ++next) {
      const DrawnVertex& drawn = vertices[*next];
      const Vertex vertex{drawn.x, drawn.y, drawn.z};
      if (!window.covers(vertex)) return;
      normals[*next] = octahedral_normal(weighted(window.negative_gradient(vertex), weights));
    }
  };
  std::vector<Sample> slice(info.slice_bytes() / sizeof(Sample));
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    meshing::require(window.push(slice.data(), static_cast<std::uint32_t>(slice.size())));
    set_covered();
  }
  window.end();
  set_covered();
}

}  // namespace

std::vector<OctahedralNormal> gradient_normals(const std::vector<DrawnVertex>& vertices,
                                               const MemoryVolume& volume, double iso) {
  std::vector<OctahedralNormal> normals(vertices.size());
  std::unique_ptr<meshing::SliceReader> reader = std::make_unique<MemoryReader>(volume);
  if (!meshing::is_scanner_type(volume.info().type)) {
    MemoryReader whole(volume);
    const meshing::SampleBounds bounds = meshing::sample_bounds(whole);
    reader = meshing::narrowed(std::move(reader), bounds, iso);
  }
  meshing::with_scanner_type(reader->info().type, [&](auto type) {
    set_from_samples<decltype(type)>(*reader, vertices, normals);
  });
  return normals;
}

}  // namespace discmc::web
