#include "decoder.hpp"

#include <optional>

#include <discmc/mesh.hpp>

#include <pybind11/stl.h>

#include "exclusive.hpp"
#include "mesh_class.hpp"
#include "watch.hpp"

namespace discmc::python {
namespace {

class PythonReceiver : public MeshReceiver, public Exclusive {
 public:
  using MeshReceiver::MeshReceiver;
};

py::object header_of(const PythonReceiver& receiver) {
  const Exclusive::Use use(receiver);
  if (!receiver.report().has_header) return py::none();
  const StreamHeader& header = receiver.header();
  py::dict named;
  named["width"] = header.width;
  named["height"] = header.height;
  named["depth"] = header.depth;
  py::list spacing;
  for (const std::int32_t nanometres : header.spacing_nm) spacing.append(nanometres / 1e6);
  named["spacing"] = py::tuple(spacing);
  named["level"] = header.thresholds[0];
  named["border"] = header.border == Border::open ? "open" : "closed";
  named["channel"] = header.channel;
  named["scan"] = header.scan;
  return named;
}

std::size_t push(PythonReceiver& receiver, const py::buffer& bytes) {
  const py::buffer_info info = bytes.request();
  const Exclusive::Use use(receiver);
  const py::gil_scoped_release others_run;
  return receiver.push(static_cast<const std::uint8_t*>(info.ptr),
                       static_cast<std::size_t>(info.size * info.itemsize));
}

SharedMesh mesh(const PythonReceiver& receiver, const Options& options) {
  const Exclusive::Use use(receiver);
  Watch watch(options);
  return watch.run([&] { return shared(receiver.mesh(watch.options())); });
}

}  // namespace

void add_decoder(py::module_& module) {
  py::class_<StreamReport>(module, "Report")
      .def_readonly("has_header", &StreamReport::has_header)
      .def_readonly("has_trailer", &StreamReport::has_trailer)
      .def_readonly("holds_slices", &StreamReport::holds_slices)
      .def_readonly("is_abandoned", &StreamReport::is_abandoned)
      .def_readonly("is_unreadable", &StreamReport::is_unreadable)
      .def_readonly("is_mixed", &StreamReport::is_mixed)
      .def_readonly("bytes", &StreamReport::bytes)
      .def_readonly("packets", &StreamReport::packets)
      .def_readonly("repeated_packets", &StreamReport::repeated_packets)
      .def_readonly("damaged_packets", &StreamReport::damaged_packets)
      .def_readonly("foreign_packets", &StreamReport::foreign_packets)
      .def_readonly("lost_packets", &StreamReport::lost_packets)
      .def_readonly("regions", &StreamReport::regions)
      .def_readonly("fragments", &StreamReport::fragments)
      .def_readonly("lost_pieces", &StreamReport::lost_pieces)
      .def_readonly("rows", &StreamReport::rows)
      .def_readonly("lost_rows", &StreamReport::lost_rows)
      .def_readonly("slices", &StreamReport::slices)
      .def_property_readonly("is_complete", &StreamReport::is_complete);
  py::class_<PythonReceiver>(module, "Receiver")
      .def(py::init<std::optional<std::uint8_t>>())
      .def("push", push)
      .def("finish", exclusive<PythonReceiver>(&MeshReceiver::finish))
      .def("has_ended", exclusive<PythonReceiver>(&MeshReceiver::has_ended))
      .def("report", exclusive<PythonReceiver>(&MeshReceiver::report))
      .def("header", header_of)
      .def("mesh", mesh)
      .def("polygon_count", exclusive<PythonReceiver>(&MeshReceiver::polygon_count));
}

}  // namespace discmc::python
