#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "discmc/mesh.hpp"
#include "extraction/crossings.hpp"
#include "extraction/selection.hpp"
#include "finished_mesh.hpp"
#include "host/host_scan.hpp"
#include "owned_state.hpp"
#include "surface/joined_surface.hpp"

namespace discmc {

using namespace meshing;

class MeshBuilder::State {
 public:
  State(std::int64_t width, std::int64_t height, const Level& level, const MeshOptions& options)
      : selection_(selection_of(level)), options_(options), axes_(sweep_axes(options)) {
    check_options(options);
    if (options.smoothing > 0 || options.normals == Normals::gradient)
      throw std::invalid_argument(
          "slices that come one by one allow neither smoothing nor gradient normals; give the "
          "whole array");
    for (const std::int64_t extent : {width, height})
      if (extent < 1 || extent > max_across)
        throw std::invalid_argument("a slice has an extent of " + std::to_string(extent) +
                                    "; give 1 to " + std::to_string(max_across) + " voxels");
    grid_.dims = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 0};
    grid_.spacing_mm = axes_.spacing;
    bits_.resize(bit_row_bytes(grid_.dims[0]) * grid_.dims[1]);
    scan_.start({grid_.dims[0], grid_.dims[1], options.border}, make_sink(surface_),
                make_region_receiver(surface_));
  }

  void add(const void* samples, SampleType type) {
    if (samples == nullptr) throw std::invalid_argument("the pointer to the samples is null");
    if (!selector_) start(type);
    if (type != grid_.type)
      throw std::invalid_argument("this slice is of " + std::string(name(type)) +
                                  ", those before of " + std::string(name(grid_.type)) +
                                  "; give slices of one type");
    const std::size_t row_bytes = bit_row_bytes(grid_.dims[0]);
    selector_->select(samples, bits_.data(), row_bytes);
    for (std::size_t at = 0; at < bits_.size(); at += row_bytes) scan_.push(bits_.data() + at);
    if (crossings_) crossings_->add_slice(samples);
    report(options_, "extracting", ++slices_, 0);
  }

  Mesh finish() {
    scan_.finish();
    surface_.finish();
    std::optional<Crossings> of_polygons;
    if (options_.relaxes)
      of_polygons.emplace(std::array<std::uint32_t, 3>{grid_.dims[0], grid_.dims[1], slices_},
                          surface_.surface().polygons);
    return finished_mesh(surface_.surface(),
                         of_polygons  ? &*of_polygons
                         : crossings_ ? &crossings_->crossings()
                                      : nullptr,
                         options_, axes_, selection_.low);
  }

 private:
  void start(SampleType type) {
    grid_.type = type;
    selector_.emplace(grid_, selection_);
    if (options_.interpolates) crossings_.emplace(grid_, selection_);
  }

  Selection selection_;
  MeshOptions options_;
  SweepAxes axes_;
  SampleGrid grid_;
  std::vector<std::uint8_t> bits_;  // of the current slice
  std::optional<SliceSelector> selector_;
  std::optional<CrossingFinder> crossings_;
  JoinedSurface surface_;
  HostScan scan_;
  std::uint32_t slices_ = 0;
};

namespace {

constexpr char no_builder[] = "the builder has finished, or was moved from; construct another";

}  // namespace

MeshBuilder::MeshBuilder(std::int64_t width, std::int64_t height, const Level& level,
                         const MeshOptions& options)
    : state_(std::make_unique<State>(width, height, level, options)) {}
MeshBuilder::~MeshBuilder() = default;
MeshBuilder::MeshBuilder(MeshBuilder&&) noexcept = default;
MeshBuilder& MeshBuilder::operator=(MeshBuilder&&) noexcept = default;

void MeshBuilder::add_slice(const void* samples, SampleType type) {
  require_state(state_, no_builder).add(samples, type);
}
Mesh MeshBuilder::finish() {
  require_state(state_, no_builder);
  return std::exchange(state_, nullptr)->finish();
}

}  // namespace discmc
