// Arrays of NumPy as the library takes them.
#pragma once

#include <discmc/mesh.hpp>

#include <pybind11/numpy.h>

namespace discmc::python {

namespace py = pybind11;

/// Throws TypeError for samples of another type; the text names the remedy.
meshing::SampleType sample_type_of(const py::array& array);

/// A view of a volume: axis 0 of the array is x of the library. Owner: the array. Throws TypeError
/// and ValueError.
Samples samples_of(const py::array& volume);

/// Throws ValueError unless the array has these dimensions, and its samples are adjacent.
void require_contiguous(const py::array& array);

}  // namespace discmc::python
