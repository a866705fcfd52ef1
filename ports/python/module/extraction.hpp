// Meshes of arrays.
#ifndef DISCMC_PYTHON_EXTRACTION_HPP
#define DISCMC_PYTHON_EXTRACTION_HPP

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_extraction(pybind11::module_& module);

}  // namespace discmc::python

#endif
