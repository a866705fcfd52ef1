// The options of an extraction, and the interpreter during a call.
#ifndef DISCMC_PYTHON_OPTIONS_HPP
#define DISCMC_PYTHON_OPTIONS_HPP

#include <discmc/mesh.hpp>

#include <pybind11/pybind11.h>

namespace discmc::python {

namespace py = pybind11;

struct Options {
  MeshOptions mesh;
  py::object progress = py::none();  ///< called with step, done, all; False cancels
};

/// The options of a call during which other threads of Python run. Its progress() checks for
/// signals, such as Ctrl-C, and calls that of the user; exceptions of either end the call.
/// Limit: the options live as long as the call.
MeshOptions watched(const Options& options);

void add_options(py::module_& module);

}  // namespace discmc::python

#endif
