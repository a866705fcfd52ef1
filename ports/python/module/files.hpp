// Files, by the code of the command. Without its libraries: nothing (no_files.cpp).
#pragma once

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_files(pybind11::module_& module);

}  // namespace discmc::python
