// Meshes of arrays.
#pragma once

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_extraction(pybind11::module_& module);

}  // namespace discmc::python
