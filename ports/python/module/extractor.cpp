#include "extractor.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <discmc/discmc.hpp>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "exclusive.hpp"
#include "samples.hpp"

namespace discmc::python {
namespace {

void require(Status status) {
  if (status != Status::ok) throw py::value_error(to_string(status));
}

struct Outline {
  Incidence incidence;
  std::vector<std::vector<Vertex>> rings;  // their corners
};

/// Collects the corners of whole regions, and the bytes of their stream if there is an encoder.
class Recorder {
 public:
  SinkResult accept(const Event& event) {
    if (encoder_) {
      const SinkResult answer = encoder_->accept(event);
      if (answer != SinkResult::accepted) return answer;
    }
    switch (event.kind) {
      case Event::Kind::region:
        region_ = {event.incidence, {}};
        is_in_region_ = true;
        break;
      case Event::Kind::ring:
        end_ring();
        region_.rings.emplace_back();
        at_ = event.start;
        break;
      case Event::Kind::run:
        if (is_in_region_) add_run(event.run);
        break;
      case Event::Kind::region_end:
        end_ring();
        is_in_region_ = false;
        outlines_.push_back(std::move(region_));
        break;
      default:
        break;
    }
    return SinkResult::accepted;
  }

  void encode(const StreamLabel& label) {
    encoder_ = std::make_unique<Encoder>();
    require(encoder_->start(label,
                            {&bytes_, [](void* bytes, const std::uint8_t* more, std::size_t count) {
                               static_cast<std::string*>(bytes)->append(
                                   reinterpret_cast<const char*>(more), count);
                               return count;
                             }}));
  }

  std::vector<Outline> move_outlines() { return std::exchange(outlines_, {}); }
  std::string move_bytes() { return std::exchange(bytes_, {}); }

 private:
  // A side longer than a run continues in the next one.
  void add_run(Run run) {
    std::vector<Vertex>& corners = region_.rings.back();
    if (corners.empty()) first_ = run.direction();
    if (corners.empty() || run.direction() != last_) corners.push_back(at_);
    last_ = run.direction();
    at_ = after_run(region_.incidence, at_, run);
  }
  void end_ring() {
    if (region_.rings.empty()) return;
    std::vector<Vertex>& corners = region_.rings.back();
    if (corners.size() > 1 && first_ == last_) corners.erase(corners.begin());
  }

  std::vector<Outline> outlines_;
  std::unique_ptr<Encoder> encoder_;
  std::string bytes_;
  Outline region_{};
  bool is_in_region_ = false;
  Vertex at_{};
  Direction first_{}, last_{};  // of the ring
};

py::list to_python(const std::vector<Outline>& outlines) {
  py::list polygons;
  for (const Outline& outline : outlines) {
    py::list rings;
    for (const std::vector<Vertex>& corners : outline.rings) {
      py::array_t<double> ring({static_cast<py::ssize_t>(corners.size()), py::ssize_t{3}});
      double* to = ring.mutable_data();
      for (const Vertex& corner : corners)
        for (const std::int32_t half_steps : {corner.x, corner.y, corner.z})
          *to++ = half_steps / 2.0;
      rings.append(ring);
    }
    const Vertex normal = discmc::incidence_normal(outline.incidence);
    polygons.append(py::make_tuple(py::make_tuple(normal.x, normal.y, normal.z), rings));
  }
  return polygons;
}

/// An extractor of firmware in memory of the size that a device gives it.
class Scan : public Exclusive {
 public:
  virtual ~Scan() = default;
  virtual void push(const py::array& samples) = 0;
  virtual void skip_row(bool repeats) = 0;
  virtual void finish() = 0;
  virtual void abandon() = 0;
  virtual py::dict statistics() const = 0;
  virtual std::size_t bytes_used() const = 0;
  virtual std::pair<std::uint32_t, std::uint32_t> place() const = 0;

  py::list polygons() { return to_python(recorder_.move_outlines()); }
  py::bytes encoded() { return recorder_.move_bytes(); }

 protected:
  Recorder recorder_;
};

template <class Index>
class ScanOf final : public Scan {
 public:
  ScanOf(const Limits& limits, std::int32_t level, std::size_t bytes, const StreamLabel* label)
      : memory_(bytes) {
    if (bytes < Extractor<Index>::minimum_bytes(limits) && limits.is_valid())
      throw py::value_error("the memory is " + std::to_string(bytes) + " bytes; slices of " +
                            std::to_string(limits.width) + " x " + std::to_string(limits.height) +
                            " need at least " +
                            std::to_string(Extractor<Index>::minimum_bytes(limits)));
    if (label) recorder_.encode(*label);
    require(
        extractor_.start(limits, level, {memory_.data(), memory_.size()}, make_sink(recorder_)));
  }

  void push(const py::array& samples) override {
    require_contiguous(samples);
    const meshing::SampleType type = sample_type_of(samples);
    if (type == meshing::type_of<std::uint8_t>())
      push_all<std::uint8_t>(samples);
    else if (type == meshing::type_of<std::uint16_t>())
      push_all<std::uint16_t>(samples);
    else if (type == meshing::type_of<std::int16_t>())
      push_all<std::int16_t>(samples);
    else
      throw py::type_error("the samples are of " +
                           py::cast<std::string>(py::str(py::object(samples.dtype()))) +
                           "; devices have uint8, uint16 or int16, so convert them by "
                           "array.astype()");
  }
  void skip_row(bool repeats) override {
    require(extractor_.skip_row(repeats ? Substitute::previous_row : Substitute::off).status);
  }
  void finish() override { require(extractor_.finish()); }
  void abandon() override { require(extractor_.abandon()); }

  py::dict statistics() const override {
    const Statistics& all = extractor_.statistics();
    py::dict named;
    named["cells"] = all.cells;
    named["facets"] = all.facets;
    named["classic_triangles"] = all.classic_triangles;
    named["regions"] = all.regions;
    named["rings"] = all.rings;
    named["links"] = all.links;
    named["fragments"] = all.fragments;
    named["skipped_rows"] = all.skipped_rows;
    named["slots"] = extractor_.capacities().slots;
    named["peak_slots"] = extractor_.peaks().slots;
    named["peak_holes"] = extractor_.peaks().holes;
    return named;
  }
  std::size_t bytes_used() const override { return extractor_.bytes_used(); }
  std::pair<std::uint32_t, std::uint32_t> place() const override {
    return {extractor_.slices(), extractor_.rows()};
  }

 private:
  template <class Sample>
  void push_all(const py::array& samples) {
    const auto* at = static_cast<const Sample*>(samples.data());
    auto left = static_cast<std::uint64_t>(samples.size());
    const py::gil_scoped_release others_run;
    while (left > 0) {
      const auto count = static_cast<std::uint32_t>(
          std::min<std::uint64_t>(left, std::numeric_limits<std::uint32_t>::max()));
      const PushResult result = extractor_.push(at, count);
      if (result.status != Status::ok) {
        const py::gil_scoped_acquire interpreter;
        require(result.status);
      }
      at += result.samples;
      left -= result.samples;
    }
  }

  std::vector<std::uint8_t> memory_;
  Extractor<Index> extractor_;
};

std::unique_ptr<Scan> start(std::uint32_t width, std::uint32_t height, std::int32_t level,
                            std::size_t memory, bool is_open, unsigned index_bits, bool encodes,
                            std::array<double, 3> spacing_mm, std::uint16_t scan,
                            std::uint8_t channel) {
  const Limits limits{width, height, is_open ? Border::open : Border::closed};
  StreamLabel label;
  for (std::size_t axis = 0; axis < 3; ++axis)
    label.spacing_nm[axis] = static_cast<std::int32_t>(spacing_mm[axis] * 1e6);
  label.scan = scan;
  label.channel = channel;
  const StreamLabel* const given = encodes ? &label : nullptr;
  if (index_bits == 16)
    return std::make_unique<ScanOf<std::uint16_t>>(limits, level, memory, given);
  return std::make_unique<ScanOf<std::uint32_t>>(limits, level, memory, given);
}

}  // namespace

void add_extractor(py::module_& module) {
  py::class_<Scan>(module, "Scan")
      .def("push", exclusive<Scan>(&Scan::push))
      .def("skip_row", exclusive<Scan>(&Scan::skip_row))
      .def("finish", exclusive<Scan>(&Scan::finish))
      .def("abandon", exclusive<Scan>(&Scan::abandon))
      .def("polygons", exclusive<Scan>(&Scan::polygons))
      .def("encoded", exclusive<Scan>(&Scan::encoded))
      .def("statistics", exclusive<Scan>(&Scan::statistics))
      .def("bytes_used", exclusive<Scan>(&Scan::bytes_used))
      .def("place", exclusive<Scan>(&Scan::place));
  module.def("start", start);
  module.def("minimum_bytes", [](std::uint32_t width, std::uint32_t height, unsigned index_bits) {
    const Limits limits{width, height};
    return index_bits == 16 ? Extractor16::minimum_bytes(limits)
                            : Extractor32::minimum_bytes(limits);
  });
}

}  // namespace discmc::python
