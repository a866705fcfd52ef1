// Files, by the code of the command. Without its libraries: nothing (no_files.cpp).
#ifndef DISCMC_PYTHON_FILES_HPP
#define DISCMC_PYTHON_FILES_HPP

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_files(pybind11::module_& module);

}  // namespace discmc::python

#endif
