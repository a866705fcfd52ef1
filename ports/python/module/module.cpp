// The module discmc._discmc. The package in discmc/ checks arguments and has the documentation.
#include <discmc/version.h>
#include <discmc/mesh.hpp>

#include <pybind11/pybind11.h>

#include "decoder.hpp"
#include "extraction.hpp"
#include "extractor.hpp"
#include "files.hpp"
#include "mesh_class.hpp"
#include "options.hpp"
#include "vertex_values.hpp"

PYBIND11_MODULE(_discmc, module) {
  using namespace discmc::python;
  module.attr("version") = DISCMC_VERSION_STRING;
  py::register_exception<discmc::Cancelled>(module, "Cancelled", PyExc_RuntimeError);
  add_options(module);
  add_mesh(module);
  add_extraction(module);
  add_vertex_values(module);
  add_extractor(module);
  add_decoder(module);
  add_files(module);
}
