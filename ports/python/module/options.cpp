#include "options.hpp"

#include <chrono>
#include <type_traits>
#include <utility>

#include <pybind11/stl.h>

namespace discmc::python {
namespace {

/// Signals are looked for so often that Ctrl-C seems immediate, and so seldom that a busy
/// interpreter does not delay the call.
constexpr std::chrono::milliseconds between_looks{50};

class Watch {
 public:
  explicit Watch(const py::object& progress) : progress_(&progress) {}

  bool operator()(const MeshProgress& now) {
    const auto time = std::chrono::steady_clock::now();
    const bool is_called = !progress_->is_none();
    if (!is_called && time < next_look_) return true;
    next_look_ = time + between_looks;
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return !is_called || !(*progress_)(now.step, now.done, now.all).is(py::bool_(false));
  }

 private:
  const py::object* progress_;
  std::chrono::steady_clock::time_point next_look_{};
};

}  // namespace

MeshOptions watched(const Options& options) {
  MeshOptions all = options.mesh;
  all.progress = Watch(options.progress);
  return all;
}

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
