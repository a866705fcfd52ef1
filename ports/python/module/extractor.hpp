// The extractor of firmware, for trying the settings of a device.
#ifndef DISCMC_PYTHON_EXTRACTOR_HPP
#define DISCMC_PYTHON_EXTRACTOR_HPP

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_extractor(pybind11::module_& module);

}  // namespace discmc::python

#endif
