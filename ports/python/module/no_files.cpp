#include "files.hpp"

namespace discmc::python {

void add_files(pybind11::module_& module) {
  module.attr("has_files") = false;
}

}  // namespace discmc::python
