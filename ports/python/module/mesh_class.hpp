// A mesh whose arrays NumPy sees without copies.
#pragma once

#include <memory>
#include <utility>

#include <discmc/mesh.hpp>

#include <pybind11/pybind11.h>

namespace discmc::python {

namespace py = pybind11;

/// Owned by Python; arrays of it keep it alive.
using SharedMesh = std::shared_ptr<Mesh>;

inline SharedMesh shared(Mesh&& mesh) {
  return std::make_shared<Mesh>(std::move(mesh));
}

void add_mesh(py::module_& module);

}  // namespace discmc::python
