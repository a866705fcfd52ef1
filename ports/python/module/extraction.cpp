#include "extraction.hpp"

#include <optional>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "mesh_class.hpp"
#include "options.hpp"
#include "samples.hpp"
#include "watch.hpp"

namespace discmc::python {
namespace {

SharedMesh extract(const py::array& volume, double low, double high, const Options& options) {
  const Samples samples = samples_of(volume);
  Watch watch(options);
  return watch.run([&] { return shared(mesh_of(samples, {low, high}, watch.options())); });
}

py::dict extract_labels(const py::array& volume, const std::vector<std::int64_t>& labels,
                        const Options& options) {
  const Samples samples = samples_of(volume);
  Watch watch(options);
  std::vector<LabelMesh> found =
      watch.run([&] { return label_meshes(samples, watch.options(), labels); });
  const bool is_unsigned = samples.type() == meshing::type_of<std::uint64_t>();
  py::dict meshes;
  for (LabelMesh& each : found) {
    const py::int_ label =
        is_unsigned ? py::int_(static_cast<std::uint64_t>(each.label)) : py::int_(each.label);
    meshes[label] = shared(std::move(each.mesh));
  }
  return meshes;
}

/// A mesh from slices. The first one sets the extents.
class Slices {
 public:
  Slices(double low, double high, const Options& options) : level_(low, high), watch_(options) {}

  void add(const py::array& slice) {
    if (slice.ndim() != 2)
      throw py::value_error("slice " + std::to_string(count_) + " has " +
                            std::to_string(slice.ndim()) + " axes; give arrays of 2");
    const meshing::SampleType type = sample_type_of(slice);
    require_contiguous(slice);
    if (!builder_) {
      rows_ = slice.shape(0);
      columns_ = slice.shape(1);
      builder_.emplace(columns_, rows_, level_, watch_.options());
    }
    if (slice.shape(0) != rows_ || slice.shape(1) != columns_)
      throw py::value_error(
          "slice " + std::to_string(count_) + " has " + std::to_string(slice.shape(0)) + " x " +
          std::to_string(slice.shape(1)) + " samples, the first has " + std::to_string(rows_) +
          " x " + std::to_string(columns_) + "; give slices of one size");
    ++count_;
    {
      const void* const samples = slice.data();
      const py::gil_scoped_release others_run;
      builder_->add_slice(samples, type);
    }
    watch_.look();
  }

  SharedMesh finish() {
    if (!builder_) throw py::value_error("there is no slice; give at least one");
    return watch_.run([&] { return shared(builder_->finish()); });
  }

 private:
  Level level_;
  Watch watch_;
  std::optional<MeshBuilder> builder_;
  py::ssize_t rows_ = 0;
  py::ssize_t columns_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

void add_extraction(py::module_& module) {
  module.def("extract", extract);
  module.def("extract_labels", extract_labels);
  py::class_<Slices>(module, "Slices")
      .def(py::init<double, double, const Options&>())
      .def("add", &Slices::add)
      .def("finish", &Slices::finish);
}

}  // namespace discmc::python
