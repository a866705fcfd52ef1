// The interface of volumes that are read slice by slice.
#ifndef DISCMC_MESH_SAMPLES_SLICE_READER_HPP
#define DISCMC_MESH_SAMPLES_SLICE_READER_HPP

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sample_type.hpp"

namespace discmc::meshing {

/// The extents and the samples of a volume.
struct SampleGrid {
  /// Width, height and number of slices. Units: voxels. Limit: 1 to 32766 in x and y, 1 to 2^30 - 1
  /// in z.
  std::array<std::uint32_t, 3> dims{};
  SampleType type = SampleType::u8;
  /// Distance between neighbouring voxels along x, y and z, negative along a reversed axis. Units:
  /// millimetres. Limit: magnitude from min_spacing_mm to max_spacing_mm.
  std::array<double, 3> spacing_mm{1, 1, 1};
  /// value = slope * stored + intercept. Limit: slope > 0.
  double slope = 1;
  double intercept = 0;

  /// Returns the spacing without signs. Units: millimetres.
  std::array<double, 3> distances_mm() const {
    return {std::abs(spacing_mm[0]), std::abs(spacing_mm[1]), std::abs(spacing_mm[2])};
  }
  /// Returns the size of a slice. Units: bytes.
  std::uint64_t slice_bytes() const {
    return std::uint64_t{dims[0]} * dims[1] * sample_bytes(type);
  }
};

/// The limit of SampleGrid::dims. Units: voxels along x and y.
constexpr std::int64_t max_across = 32766;

/// One pass over a volume, first slice to last.
class SliceReader {
 public:
  SliceReader() = default;
  SliceReader(const SliceReader&) = delete;
  SliceReader& operator=(const SliceReader&) = delete;
  virtual ~SliceReader() = default;

  /// Valid during the life of the reader.
  virtual const SampleGrid& info() const = 0;

  /// Writes the next slice, rows of x from y = 0, samples in native byte order.
  /// Size: info().slice_bytes(), owned by the caller. An exception leaves the slice undefined.
  virtual void read_slice(void* samples) = 0;

  /// Skips the next slice, without reading it if the source allows this.
  virtual void skip_slice() {
    std::vector<std::uint8_t> dropped(info().slice_bytes());
    read_slice(dropped.data());
  }
};

}  // namespace discmc::meshing

#endif
