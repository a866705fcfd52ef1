// The receiver of a device's streams.
#ifndef DISCMC_PYTHON_DECODER_HPP
#define DISCMC_PYTHON_DECODER_HPP

#include <pybind11/pybind11.h>

namespace discmc::python {

void add_decoder(pybind11::module_& module);

}  // namespace discmc::python

#endif
