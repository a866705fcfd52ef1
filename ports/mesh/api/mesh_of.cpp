#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "array_reader.hpp"
#include "discmc/mesh.hpp"
#include "extraction/labels.hpp"
#include "extraction/surfaces.hpp"
#include "finished_mesh.hpp"
#include "meshes/measures.hpp"
#include "smoothing/smoothed_labels.hpp"
#include "smoothing/smoothed_volume.hpp"
#include "surface/joined_surface.hpp"

namespace discmc {

using namespace meshing;

std::int64_t Extents::limited(std::int64_t voxels) {
  constexpr std::int64_t max_voxels = (std::int64_t{1} << 30) - 1;
  if (voxels < 1 || voxels > max_voxels)
    throw std::invalid_argument("an extent is " + std::to_string(voxels) + "; give 1 to " +
                                std::to_string(max_voxels) + " voxels");
  return voxels;
}

void Extents::require_two_short() const {
  if (std::count_if(voxels_.begin(), voxels_.end(),
                    [](std::int64_t voxels) { return voxels > max_across; }) > 1)
    throw std::invalid_argument("the array has " + std::to_string(voxels_[0]) + " x " +
                                std::to_string(voxels_[1]) + " x " + std::to_string(voxels_[2]) +
                                " samples; two extents must be at most " +
                                std::to_string(max_across) + ", so divide the array");
}

namespace {

Strides contiguous(const Extents& extents) {
  const auto distance = [](std::int64_t samples) {
    return static_cast<std::ptrdiff_t>(static_cast<std::size_t>(samples));
  };
  return {1, distance(extents[0]), distance(extents[0] * extents[1])};
}

}  // namespace

Samples::Samples(const void* samples, SampleType type, const Extents& extents)
    : Samples(samples, type, extents, contiguous(extents)) {}

Samples::Samples(const void* samples, SampleType type, const Extents& extents,
                 const Strides& strides)
    : data_(samples), type_(type), extents_(extents), strides_(strides) {
  if (samples == nullptr) throw std::invalid_argument("the pointer to the samples is null");
}

void Samples::require_count(std::size_t count, const Extents& extents) {
  if (count != static_cast<std::size_t>(extents.count()))
    throw std::invalid_argument("the vector has " + std::to_string(count) +
                                " samples, and the extents " + std::to_string(extents[0]) + " x " +
                                std::to_string(extents[1]) + " x " + std::to_string(extents[2]) +
                                " need " + std::to_string(extents.count()));
}

namespace {

void check_gradient(const MeshOptions& options, const std::vector<Selection>& selections) {
  if (options.normals != Normals::gradient) return;
  if (options.smoothing > 0)
    throw std::invalid_argument(
        "a smoothed surface has no gradient normals; ask for surface normals");
  for (const Selection& selection : selections)
    if (selection.has_upper_end())
      throw std::invalid_argument(
          "gradient normals need a level without a high end; ask for surface normals");
}

SurfaceOptions surface_options(const MeshOptions& options, std::uint64_t slices) {
  SurfaceOptions surfaces;
  surfaces.border = options.border;
  surfaces.progress = reporter_here(options, "extracting", slices);
  if (threads_of(options) > 1) surfaces.jobs = threads_of(options);
  return surfaces;
}

LabelOptions label_options(const SampleGrid& info, const MeshOptions& options,
                           const std::vector<std::int64_t>& labels) {
  LabelOptions result;
  result.border = options.border;
  result.jobs = threads_of(options);
  result.progress = [&options, slices = info.dims[2]](std::uint32_t done) {
    report(options, "extracting", done, slices);
  };
  if (labels.empty()) return result;
  std::set<LabelValue> chosen;
  for (const std::int64_t label : labels)
    if (info.type == SampleType::u64)
      chosen.insert(LabelValue(static_cast<std::uint64_t>(label)));
    else
      chosen.insert(LabelValue(label));
  result.chosen = std::move(chosen);
  return result;
}

void keep_volume(JoinedSurface& surface, CrossingFinder& crossings, const SampleGrid& info,
                 const MeshOptions& options, const SweepAxes& axes) {
  surface.surface().spacing_mm = axes.spacing;
  VolumeKeeping keeping =
      SmoothedVolume::keeping(info, options.smoothing, options.tolerance, options.border);
  keeping.jobs = threads_of(options);
  keeping.check = [&options] { report(options, "smoothing", 0, 0); };
  keep_volumes({{&surface.surface(), &crossings.crossings()}}, keeping);
}

}  // namespace

std::vector<Mesh> meshes_of(const Samples& samples, const std::vector<Level>& levels,
                            const MeshOptions& options) {
  check_options(options);
  std::vector<Selection> selections;
  for (const Level& level : levels) selections.push_back(selection_of(level));
  check_gradient(options, selections);
  if (options.smoothing > 0 && levels.size() > 1)
    throw std::invalid_argument("smoothing takes one level; extract each by itself");
  const AxisOrder order = axis_order(samples);
  const SweepAxes axes = sweep_axes(options, order);
  ArrayReader array(samples, order, axes.spacing);
  std::unique_ptr<SmoothedVolume> smoothed;
  if (options.smoothing > 0 && !selections.empty()) {
    smoothed = std::make_unique<SmoothedVolume>(array, selections[0], nullptr, options.smoothing);
    selections[0] = {0};
  }
  SliceReader& volume = smoothed ? static_cast<SliceReader&>(*smoothed) : array;

  std::vector<std::unique_ptr<JoinedSurface>> surfaces;
  std::vector<std::unique_ptr<CrossingFinder>> crossings;
  std::vector<SurfaceRequest> requests;
  for (const Selection& selection : selections) {
    surfaces.push_back(std::make_unique<JoinedSurface>(Kept::polygons, threads_of(options)));
    JoinedSurface& surface = *surfaces.back();
    requests.push_back({selection, make_sink(surface), nullptr, &surface.builder(), nullptr,
                        make_region_receiver(surface)});
    if (!is_interpolated(options)) continue;
    crossings.push_back(std::make_unique<CrossingFinder>(volume.info(), selection, Vertex{0, 0, 0},
                                                         smoothed != nullptr));
    requests.back().crossings = crossings.back().get();
  }
  if (!requests.empty())
    extract_surfaces(volume, surface_options(options, volume.info().dims[2]), requests);

  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surfaces[i]->finish();
    if (smoothed) keep_volume(*surfaces[i], *crossings[i], volume.info(), options, axes);
    std::optional<Crossings> of_polygons;
    if (options.relaxes) of_polygons.emplace(volume.info().dims, surfaces[i]->surface().polygons);
    meshes.push_back(
        finished_mesh(surfaces[i]->surface(),
                      of_polygons         ? &*of_polygons
                      : crossings.empty() ? nullptr
                                          : &crossings[i]->crossings(),
                      options, axes, selections[i].low,
                      [&] { return std::make_unique<ArrayReader>(samples, order, axes.spacing); }));
    surfaces[i].reset();  // frees memory for the next mesh
  }
  return meshes;
}

Mesh mesh_of(const Samples& samples, const Level& level, const MeshOptions& options) {
  return std::move(meshes_of(samples, {level}, options)[0]);
}

std::vector<LabelMesh> label_meshes(const Samples& samples, const MeshOptions& options,
                                    const std::vector<std::int64_t>& labels) {
  check_options(options);
  if (is_floating(samples.type()))
    throw std::invalid_argument("labels are whole numbers; convert the array to an integer type");
  if (options.relaxes)
    throw std::invalid_argument(
        "relaxed labels would not share their walls: ask for smoothing in place of relaxation");
  if (options.normals == Normals::gradient || (options.interpolates && options.smoothing == 0))
    throw std::invalid_argument(
        "labels cannot be combined with gradient normals or interpolation; use surface normals and "
        "smoothing");
  const AxisOrder order = axis_order(samples);
  const SweepAxes axes = sweep_axes(options, order);
  ArrayReader array(samples, order, axes.spacing);
  const LabelOptions extraction = label_options(array.info(), options, labels);
  std::vector<SmoothedLabel> smoothed;
  std::vector<LabelledSurface> extracted;
  if (options.smoothing > 0)
    smoothed = smoothed_labels(
        array, extraction, options.smoothing, options.tolerance,
        [&](std::size_t done, std::size_t total) { report(options, "smoothing", done, total); });
  else
    extracted = extract_labels(array, extraction);

  std::vector<LabelMesh> meshes;
  const auto add = [&](LabelledSurface& label, Crossings* crossings) {
    meshes.push_back({static_cast<std::int64_t>(label.label.bits()), label.voxels,
                      finished_mesh(label.surface, crossings, options, axes, 0)});
  };
  for (SmoothedLabel& each : smoothed) add(each.surface, &each.crossings.crossings());
  for (LabelledSurface& each : extracted) add(each, nullptr);
  return meshes;
}

MeshMeasures measures_of(const Mesh& mesh) {
  FaceMesh face_mesh;
  face_mesh.vertices_mm = mesh.vertices;
  for (const auto& triangle : mesh.triangles) {
    face_mesh.corners.insert(face_mesh.corners.end(), triangle.begin(), triangle.end());
    face_mesh.face_begin.push_back(face_mesh.corners.size());
  }
  const Measures computed = measures_of(face_mesh);
  MeshMeasures measures;
  measures.area = computed.area_mm2;
  measures.least = computed.min_mm;
  measures.greatest = computed.max_mm;
  measures.is_closed = computed.enclosed.has_value();
  if (!computed.enclosed) return measures;
  measures.volume = computed.enclosed->volume_mm3;
  measures.centre = computed.enclosed->centre_mm;
  measures.bodies = computed.enclosed->bodies;
  measures.cavities = computed.enclosed->cavities;
  return measures;
}

}  // namespace discmc
