// The options of an extraction.
#pragma once

#include <discmc/mesh.hpp>

#include <pybind11/pybind11.h>

namespace discmc::python {

namespace py = pybind11;

struct Options {
  MeshOptions mesh;
  py::object progress = py::none();  ///< called with step, done, all; False cancels
};

void add_options(py::module_& module);

}  // namespace discmc::python
