// The values that marching_cubes() of scikit-image returns beside the vertices.
#pragma once

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_vertex_values(pybind11::module_& module);

}  // namespace discmc::python
