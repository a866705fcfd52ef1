#include "mesh_class.hpp"

#include <algorithm>
#include <array>
#include <memory>
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

// ---- a copy for another process ----

py::tuple arrays_of(const py::object& self) {
  return py::make_tuple(self.attr("vertices"), self.attr("faces"), self.attr("normals"),
                        self.attr("ring_begin"), self.attr("corner_begin"), self.attr("corners"),
                        self.attr("polygon_normals"));
}

template <class Number>
using DenseArray = py::array_t<Number, py::array::c_style | py::array::forcecast>;

template <class Number>
void assign(std::vector<Number>& numbers, const py::object& from) {
  const auto array = py::cast<DenseArray<Number>>(from);
  numbers.assign(array.data(), array.data() + array.size());
}

template <class Number>
void assign(std::vector<std::array<Number, 3>>& rows, const py::object& from) {
  const auto array = py::cast<DenseArray<Number>>(from);
  rows.resize(static_cast<std::size_t>(array.size()) / 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::copy_n(array.data() + 3 * i, 3, rows[i].begin());
}

SharedMesh mesh_of_arrays(const py::tuple& arrays) {
  auto mesh = std::make_shared<Mesh>();
  assign(mesh->vertices, arrays[0]);
  assign(mesh->triangles, arrays[1]);
  assign(mesh->normals, arrays[2]);
  assign(mesh->polygons.ring_begin, arrays[3]);
  assign(mesh->polygons.corner_begin, arrays[4]);
  assign(mesh->polygons.corners, arrays[5]);
  assign(mesh->polygons.normals, arrays[6]);
  return mesh;
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
          py::call_guard<py::gil_scoped_release>())
      .def(py::pickle(&arrays_of, &mesh_of_arrays));
}

}  // namespace discmc::python
