// Volumes in memory with the interface of the command's readers, and the meshes of their surfaces.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "extraction/extraction.hpp"
#include "meshes/mesh.hpp"
#include "oracle/volume.hpp"
#include "surface/surface_builder.hpp"
#include "volumes/volume.hpp"

namespace sample_reader {

using discmc::command::VolumeInfo;
using discmc::meshing::FaceMesh;
using discmc::meshing::Point;
using discmc::meshing::SampleType;
using discmc::reference::BitVolume;
using discmc::reference::Size;

/// Samples of any type, x fastest, then y, then z.
class SampleReader final : public discmc::command::VolumeReader {
 public:
  SampleReader(Size size, std::vector<int> samples, const Point& spacing_mm = {1, 1, 1},
               SampleType type = SampleType::u8)
      : samples_(std::move(samples)) {
    info_.dims = {size.width, size.height, size.depth};
    info_.type = type;
    info_.spacing_mm = spacing_mm;
  }
  /// On voxels are 150, the others 50.
  explicit SampleReader(const BitVolume& volume, const Point& spacing_mm = {1, 1, 1},
                        SampleType type = SampleType::u8)
      : SampleReader({volume.width, volume.height, volume.depth}, {}, spacing_mm, type) {
    for (const std::uint8_t on : volume.on) samples_.push_back(on != 0 ? 150 : 50);
  }

  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override {
    discmc::meshing::with_sample_type(info_.type, [&](auto type) {
      using Sample = decltype(type);
      auto* const slice = static_cast<Sample*>(samples);
      for (std::size_t i = 0; i < info_.slice_bytes() / sizeof(Sample); ++i)
        slice[i] = static_cast<Sample>(samples_.at(next_++));
    });
  }

 private:
  std::vector<int> samples_;
  VolumeInfo info_;
  std::size_t next_ = 0;
};

/// A threshold between on and off of a volume of bits.
constexpr std::int32_t bit_threshold = 100;

inline discmc::meshing::Surface surface_of(const BitVolume& volume,
                                           const Point& spacing_mm = {1, 1, 1}) {
  SampleReader reader(volume, spacing_mm);
  discmc::meshing::SurfaceBuilder builder;
  extract(reader, {{bit_threshold}, discmc::Border::closed}, discmc::make_sink(builder));
  builder.surface().spacing_mm = spacing_mm;
  return std::move(builder.surface());
}

inline FaceMesh merged_mesh(const BitVolume& volume, discmc::meshing::Faces faces,
                            const Point& spacing_mm = {1, 1, 1}) {
  return build_mesh(surface_of(volume, spacing_mm), {true, faces});
}

/// Inverts the voxels from the first to the last.
inline void put_box(BitVolume& volume, const discmc::Vertex& first, const discmc::Vertex& last,
                    std::uint8_t on) {
  for (std::int32_t z = first.z; z <= last.z; ++z)
    for (std::int32_t y = first.y; y <= last.y; ++y)
      for (std::int32_t x = first.x; x <= last.x; ++x) volume.on[volume.index(x, y, z)] = on;
}

}  // namespace sample_reader
