// The extractor of firmware, for trying the settings of a device.
#pragma once

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_extractor(pybind11::module_& module);

}  // namespace discmc::python
