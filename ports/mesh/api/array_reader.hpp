// Reads an array in memory as the slices of a sweep.
#ifndef DISCMC_MESH_API_ARRAY_READER_HPP
#define DISCMC_MESH_API_ARRAY_READER_HPP

#include <array>
#include <cstddef>
#include <cstdint>

#include "discmc/mesh.hpp"
#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// Maps each axis of the sweep to an axis of the array.
using AxisOrder = std::array<std::size_t, 3>;

/// Returns the order that reads memory from front to back, so that every order of axes is equally
/// fast.
AxisOrder axis_order(const Samples& samples);

/// Reads an array slice by slice. Owner of the samples: the caller.
class ArrayReader final : public SliceReader {
 public:
  /// spacing: along the axes of the sweep.
  ArrayReader(const Samples& samples, const AxisOrder& order, const std::array<double, 3>& spacing);

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* slice) override;
  void skip_slice() override { ++next_; }

 private:
  const std::uint8_t* samples_;
  SampleGrid info_;
  Strides stride_bytes_;
  std::ptrdiff_t next_ = 0;  // next slice
};

}  // namespace discmc::meshing

#endif
