#include "files.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "mesh_class.hpp"
#include "mesh_files/mesh_files.hpp"
#include "options.hpp"
#include "samples/sample_type.hpp"
#include "volumes/volume.hpp"
#include "volumes/volume_error.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace discmc::python {
namespace {

namespace fs = std::filesystem;
using command::VolumeInfo;
using command::VolumeReader;

// format_name: a name with the extension of the format.
void write_mesh(const Mesh& mesh, const fs::path& format_name, const fs::path& file) {
  const command::Format format = command::format_of(format_name);
  command::FileMesh faces;
  faces.vertices_mm = mesh.vertices;
  faces.normals = mesh.normals;
  faces.corners.reserve(3 * mesh.triangles.size());
  faces.face_begin.reserve(mesh.triangles.size() + 1);
  for (const auto& triangle : mesh.triangles) {
    faces.corners.insert(faces.corners.end(), triangle.begin(), triangle.end());
    faces.face_begin.push_back(faces.corners.size());
  }
  std::ofstream out(file, std::ios::binary);
  command::write_mesh(faces, format, out);
  out.close();
  if (!out) throw std::runtime_error(file.string() + " could not be written; is the disk full?");
}

py::dtype type_of(meshing::SampleType type) {
  return meshing::with_sample_type(type,
                                   [](auto typed) { return py::dtype::of<decltype(typed)>(); });
}

// Reads all slices. look(): looks for signals; with the interpreter.
void read_slices(VolumeReader& reader, std::uint8_t* to) {
  const py::gil_scoped_release others_run;
  for (std::uint32_t slice = 0; slice < reader.info().dims[2]; ++slice) {
    reader.read_slice(to);
    to += reader.info().slice_bytes();
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

const char* name_of(const VolumeInfo& info) {
  if (!info.placement || info.placement->space == Space::scanner) return "scanner";
  return info.placement->space == Space::lps ? "lps" : "ras";
}

// As Python's own functions, if there is no such file.
std::unique_ptr<VolumeReader> opened(const fs::path& file, const command::VolumeOptions& options) {
  try {
    return command::open_volume(file, options);
  } catch (const command::VolumeError& error) {
    if (error.fault() != "there is no such file") throw;
    const py::gil_scoped_acquire interpreter;
    PyErr_SetString(PyExc_FileNotFoundError, error.what());
    throw py::error_already_set();
  }
}

py::dict read_volume(const fs::path& file, const command::VolumeOptions& options) {
  std::unique_ptr<VolumeReader> reader;
  {
    const py::gil_scoped_release others_run;
    reader = opened(file, options);
  }
  const VolumeInfo& info = reader->info();
  py::array array(type_of(info.type),
                  std::vector<py::ssize_t>{info.dims[2], info.dims[1], info.dims[0]});
  read_slices(*reader, static_cast<std::uint8_t*>(array.mutable_data()));
  py::dict volume;
  volume["array"] = array;
  volume["spacing"] = info.spacing_mm;
  volume["slope"] = info.slope;
  volume["intercept"] = info.intercept;
  const meshing::VolumePlacement placement =
      info.placement.value_or(meshing::along_coordinates(info.spacing_mm));
  volume["axes"] = placement.axes_mm;
  volume["origin"] = placement.origin_mm;
  volume["space"] = name_of(info);
  volume["notes"] = reader->notes();
  volume["format"] = info.format;
  return volume;
}

}  // namespace

void add_files(py::module_& module) {
  module.attr("has_files") = true;
  module.def("write_mesh", write_mesh, py::call_guard<py::gil_scoped_release>());
  py::class_<command::VolumeOptions>(module, "VolumeOptions")
      .def(py::init<>())
      .def_readwrite("spacing", &command::VolumeOptions::spacing_mm)
      .def_readwrite("series", &command::VolumeOptions::series)
      .def_readwrite("frame", &command::VolumeOptions::frame)
      .def_readwrite("channel", &command::VolumeOptions::channel)
      .def_readwrite("level", &command::VolumeOptions::level);
  module.def("read_volume", read_volume);
}

}  // namespace discmc::python
