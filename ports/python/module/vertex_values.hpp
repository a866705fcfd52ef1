// The values that marching_cubes() of scikit-image returns beside the vertices.
#ifndef DISCMC_PYTHON_VERTEX_VALUES_HPP
#define DISCMC_PYTHON_VERTEX_VALUES_HPP

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_vertex_values(pybind11::module_& module);

}  // namespace discmc::python

#endif
