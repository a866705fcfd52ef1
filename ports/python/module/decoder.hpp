// The receiver of a device's streams.
#pragma once

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_decoder(pybind11::module_& module);

}  // namespace discmc::python
