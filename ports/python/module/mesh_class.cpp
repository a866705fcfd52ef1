#include "mesh_class.hpp"

#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace discmc::python {
namespace {

// What measures_of() and the writers see stays what Python sees.
py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

template <class Number>
py::array view(const py::object& owner, const std::vector<Number>& numbers) {
  return read_only(
      py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data(), owner));
}

template <class Number>
py::array view(const py::object& owner, const std::vector<std::array<Number, 3>>& rows) {
  const auto count = static_cast<py::ssize_t>(rows.size());
  const Number* const first = rows.empty() ? nullptr : rows[0].data();
  return read_only(py::array_t<Number>({count, py::ssize_t{3}}, first, owner));
}

// A property that is a vector of the mesh.
template <class Find>
auto array_property(Find find) {
  return [find](const py::object& self) { return view(self, find(py::cast<const Mesh&>(self))); };
}

}  // namespace

void add_mesh(py::module_& module) {
  py::class_<MeshMeasures>(module, "Measures")
      .def_readonly("area", &MeshMeasures::area)
      .def_readonly("least", &MeshMeasures::least)
      .def_readonly("greatest", &MeshMeasures::greatest)
      .def_readonly("is_closed", &MeshMeasures::is_closed)
      .def_readonly("volume", &MeshMeasures::volume)
      .def_readonly("centre", &MeshMeasures::centre)
      .def_readonly("bodies", &MeshMeasures::bodies)
      .def_readonly("cavities", &MeshMeasures::cavities);

  py::class_<Mesh, SharedMesh>(module, "MeshData")
      .def_property_readonly(
          "vertices", array_property([](const Mesh& mesh) -> auto& { return mesh.vertices; }))
      .def_property_readonly(
          "faces", array_property([](const Mesh& mesh) -> auto& { return mesh.triangles; }))
      .def_property_readonly("normals",
                             array_property([](const Mesh& mesh) -> auto& { return mesh.normals; }))
      .def_property_readonly("ring_begin", array_property([](const Mesh& mesh) -> auto& {
                               return mesh.polygons.ring_begin;
                             }))
      .def_property_readonly("corner_begin", array_property([](const Mesh& mesh) -> auto& {
                               return mesh.polygons.corner_begin;
                             }))
      .def_property_readonly("corners", array_property([](const Mesh& mesh) -> auto& {
                               return mesh.polygons.corners;
                             }))
      .def_property_readonly("polygon_normals", array_property([](const Mesh& mesh) -> auto& {
                               return mesh.polygons.normals;
                             }))
      .def(
          "measures", [](const Mesh& mesh) { return measures_of(mesh); },
          py::call_guard<py::gil_scoped_release>());
}

}  // namespace discmc::python
