#include "vertex_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <pybind11/stl.h>

#include "mesh_class.hpp"
#include "samples.hpp"
#include "samples/sample_type.hpp"

namespace discmc::python {
namespace {

struct Range {
  std::ptrdiff_t first, last;
};

// The first and last cell along an axis that touch the vertex: cell c lies between samples c and c
// + 1. A vertex on a sample, as far as rounding shows, touches two.
Range cells_around(double coordinate, std::int64_t extent) {
  const double nearest = std::round(coordinate);
  const bool is_on_sample = std::abs(coordinate - nearest) < 1e-6;
  const double first = is_on_sample ? nearest - 1 : std::floor(coordinate);
  const double last = is_on_sample ? nearest : first;
  const auto end = static_cast<double>(std::max<std::int64_t>(extent - 2, 0));
  return {static_cast<std::ptrdiff_t>(std::clamp(first, 0.0, end)),
          static_cast<std::ptrdiff_t>(std::clamp(last, 0.0, end))};
}

template <class Sample>
class Cells {
 public:
  explicit Cells(const Samples& volume)
      : samples_(static_cast<const Sample*>(volume.data())), strides_(volume.strides()) {
    std::size_t count = 0;
    for (const std::ptrdiff_t z : steps(volume, 2))
      for (const std::ptrdiff_t y : steps(volume, 1))
        for (const std::ptrdiff_t x : steps(volume, 0)) corners_[count++] = x + y + z;
  }

  // The greatest difference of two samples of a cell.
  double range(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) const {
    const Sample* const first = samples_ + x * strides_[0] + y * strides_[1] + z * strides_[2];
    Sample least = *first, greatest = *first;
    for (const std::ptrdiff_t corner : corners_) {
      least = std::min(least, first[corner]);
      greatest = std::max(greatest, first[corner]);
    }
    return static_cast<double>(greatest) - static_cast<double>(least);
  }

 private:
  static std::array<std::ptrdiff_t, 2> steps(const Samples& volume, std::size_t axis) {
    return {0, volume.extents()[axis] > 1 ? volume.strides()[axis] : 0};
  }

  const Sample* samples_;
  Strides strides_;
  std::array<std::ptrdiff_t, 8> corners_{};
};

template <class Sample>
void write_ranges(const Samples& volume, const Mesh& mesh, const std::array<double, 3>& spacing,
                  float* values) {
  const Cells<Sample> cells(volume);
  for (const auto& vertex : mesh.vertices) {
    std::array<Range, 3> around{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      around[axis] = cells_around(vertex[axis] / spacing[axis], volume.extents()[axis]);
    double greatest = 0;
    for (std::ptrdiff_t x = around[0].first; x <= around[0].last; ++x)
      for (std::ptrdiff_t y = around[1].first; y <= around[1].last; ++y)
        for (std::ptrdiff_t z = around[2].first; z <= around[2].last; ++z)
          greatest = std::max(greatest, cells.range(x, y, z));
    *values++ = static_cast<float>(greatest);
  }
}

// How far the samples of a cell that touches the vertex are apart, at most.
py::array_t<float> ranges_around(const py::array& volume, const Mesh& mesh,
                                 const std::array<double, 3>& spacing) {
  const Samples samples = samples_of(volume);
  py::array_t<float> values(static_cast<py::ssize_t>(mesh.vertices.size()));
  float* const first = values.mutable_data();
  const py::gil_scoped_release others_run;
  meshing::with_sample_type(samples.type(), [&](auto typed) {
    write_ranges<decltype(typed)>(samples, mesh, spacing, first);
  });
  return values;
}

}  // namespace

void add_vertex_values(py::module_& module) {
  module.def("ranges_around", ranges_around);
}

}  // namespace discmc::python
