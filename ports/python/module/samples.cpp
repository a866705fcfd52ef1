#include "samples.hpp"

#include <string>

namespace discmc::python {

using meshing::type_of;

namespace {

std::string text(const py::handle& object) {
  return py::cast<std::string>(py::str(object));
}

}  // namespace

meshing::SampleType sample_type_of(const py::array& array) {
  const py::dtype type = array.dtype();
  const std::string fault = "the samples are of " + text(type);
  if (!py::cast<bool>(type.attr("isnative")))
    throw py::type_error(fault +
                         ", in the byte order of another machine; convert them by "
                         "array.astype(array.dtype.newbyteorder('='))");
  const auto bytes = type.itemsize();
  switch (type.kind()) {
    case 'b':
    case 'u':
      if (bytes == 1) return type_of<std::uint8_t>();
      if (bytes == 2) return type_of<std::uint16_t>();
      if (bytes == 4) return type_of<std::uint32_t>();
      return type_of<std::uint64_t>();
    case 'i':
      if (bytes == 1) return type_of<std::int8_t>();
      if (bytes == 2) return type_of<std::int16_t>();
      if (bytes == 4) return type_of<std::int32_t>();
      return type_of<std::int64_t>();
    case 'f':
      if (bytes == 4) return type_of<float>();
      if (bytes == 8) return type_of<double>();
      throw py::type_error(fault + "; convert them by array.astype('float32') or 'float64'");
    default:
      throw py::type_error(fault +
                           "; convert them to bool, an integer type, float32 or float64 by "
                           "array.astype()");
  }
}

Samples samples_of(const py::array& volume) {
  if (volume.ndim() != 3)
    throw py::value_error("the array has " + std::to_string(volume.ndim()) +
                          " axes; a volume has 3, so choose a part of it, as array[0]");
  const meshing::SampleType type = sample_type_of(volume);
  const auto bytes = volume.itemsize();
  const bool is_aligned = py::cast<bool>(volume.attr("flags").attr("aligned"));
  Strides strides{};
  bool is_whole = is_aligned;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    strides[axis] = volume.strides(static_cast<py::ssize_t>(axis)) / bytes;
    is_whole = is_whole && volume.strides(static_cast<py::ssize_t>(axis)) % bytes == 0;
  }
  if (!is_whole)
    throw py::value_error(
        "the samples lie between other fields of a structure, or at odd addresses; copy them by "
        "numpy.ascontiguousarray(array)");
  return {volume.data(), type, {volume.shape(0), volume.shape(1), volume.shape(2)}, strides};
}

void require_contiguous(const py::array& array) {
  if ((array.flags() & py::array::c_style) == 0)
    throw py::value_error(
        "the rows are not adjacent in memory; copy them by numpy.ascontiguousarray(array)");
}

}  // namespace discmc::python
