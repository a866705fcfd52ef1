#include "options.hpp"

#include <type_traits>
#include <utility>

#include <pybind11/stl.h>

namespace discmc::python {
void add_options(py::module_& module) {
  py::enum_<Border>(module, "Border").value("closed", Border::closed).value("open", Border::open);
  py::enum_<Normals>(module, "Normals")
      .value("none", Normals::none)
      .value("surface", Normals::surface)
      .value("gradient", Normals::gradient);
  py::class_<Options> type(module, "Options");
  type.def(py::init<>());
  const auto property = [&type](const char* name, auto member) {
    using Value = std::decay_t<decltype(std::declval<MeshOptions>().*member)>;
    type.def_property(
        name, [member](const Options& options) { return options.mesh.*member; },
        [member](Options& options, const Value& value) { options.mesh.*member = value; });
  };
  property("spacing", &MeshOptions::spacing);
  property("placement", &MeshOptions::placement);
  property("border", &MeshOptions::border);
  property("interpolates", &MeshOptions::interpolates);
  property("relaxes", &MeshOptions::relaxes);
  property("tolerance", &MeshOptions::tolerance);
  property("smoothing", &MeshOptions::smoothing);
  property("triangles", &MeshOptions::triangles);
  property("max_error", &MeshOptions::max_error);
  property("normals", &MeshOptions::normals);
  property("polygons", &MeshOptions::polygons);
  property("threads", &MeshOptions::threads);
  type.def_readwrite("progress", &Options::progress);
}

}  // namespace discmc::python
