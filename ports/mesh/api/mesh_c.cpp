// Implements mesh.h by mesh.hpp.
#include <cstdio>
#include <memory>
#include <new>
#include <utility>

#include "discmc/mesh.h"
#include "discmc/mesh.hpp"

namespace discmc::meshing {
namespace {

static_assert(DISCMC_SAMPLES_U8 == int{static_cast<std::uint8_t>(type_of<std::uint8_t>())} &&
              DISCMC_SAMPLES_I64 == int{static_cast<std::uint8_t>(type_of<std::int64_t>())} &&
              DISCMC_SAMPLES_F64 == int{static_cast<std::uint8_t>(type_of<double>())});
static_assert(DISCMC_NORMALS_GRADIENT == static_cast<int>(Normals::gradient));

Samples samples_of(const discmc_samples* pointer) {
  if (pointer == nullptr) throw std::invalid_argument("the pointer to discmc_samples is null");
  const discmc_samples& from = *pointer;
  if (from.type < DISCMC_SAMPLES_U8 || from.type > DISCMC_SAMPLES_F64)
    throw std::invalid_argument("the type of the samples is " + std::to_string(from.type) +
                                "; give DISCMC_SAMPLES_U8 to DISCMC_SAMPLES_F64");
  const Extents extents(from.extents[0], from.extents[1], from.extents[2]);
  const auto type = static_cast<SampleType>(from.type);
  const Strides strides{from.strides[0], from.strides[1], from.strides[2]};
  return strides == Strides{} ? Samples(from.data, type, extents)
                              : Samples(from.data, type, extents, strides);
}

MeshOptions options_of(const discmc_mesh_options* from) {
  MeshOptions options;
  if (from == nullptr) return options;
  if (from->normals < DISCMC_NORMALS_NONE || from->normals > DISCMC_NORMALS_GRADIENT)
    throw std::invalid_argument("normals is " + std::to_string(from->normals) +
                                "; give DISCMC_NORMALS_NONE to DISCMC_NORMALS_GRADIENT");
  if (from->threads < -1)
    throw std::invalid_argument("threads is " + std::to_string(from->threads) +
                                "; give -1, or the number of threads");
  const double* const spacing = from->spacing;
  if (spacing[0] != 0 || spacing[1] != 0 || spacing[2] != 0)
    options.spacing = {spacing[0], spacing[1], spacing[2]};
  if (from->placement != nullptr) {
    options.placement.emplace();
    for (std::size_t i = 0; i < 12; ++i) (*options.placement)[i / 4][i % 4] = from->placement[i];
  }
  if (from->has_open_border != 0) options.border = Border::open;
  options.interpolates = from->interpolates != 0;
  options.relaxes = from->relaxes != 0;
  if (from->tolerance != 0) options.tolerance = from->tolerance;
  options.smoothing = from->smoothing;
  options.triangles = from->triangles;
  options.max_error = from->max_error;
  options.normals = static_cast<Normals>(from->normals);
  options.polygons = from->polygons != 0;
  if (from->threads != 0)
    options.threads = from->threads < 0 ? 0 : static_cast<unsigned>(from->threads);
  if (from->progress != nullptr)
    options.progress = [from](const MeshProgress& at) {
      return from->progress(from->user, at.step, at.done, at.all) != 0;
    };
  return options;
}

// Returns the numbers of all tuples, one after another.
template <class Tuple>
const typename Tuple::value_type* numbers_of(const std::vector<Tuple>& tuples) {
  return tuples.empty() ? nullptr : tuples[0].data();
}

discmc_mesh view_of(const Mesh& mesh) {
  discmc_mesh view{};
  view.vertex_count = mesh.vertices.size();
  view.vertices = numbers_of(mesh.vertices);
  view.normals = numbers_of(mesh.normals);
  view.triangle_count = mesh.triangles.size();
  view.triangles = numbers_of(mesh.triangles);
  view.polygon_count = mesh.polygons.size();
  view.ring_begin = mesh.polygons.ring_begin.data();
  view.corner_begin = mesh.polygons.corner_begin.data();
  view.corners = mesh.polygons.corners.data();
  view.polygon_normals = numbers_of(mesh.polygons.normals);
  return view;
}

struct LabelMeshes {
  std::vector<LabelMesh> meshes;
  std::vector<discmc_label_mesh> views;
};

// Calls make(), and converts its exceptions to an error with a message.
template <class Result, class Make>
std::int32_t result_of(Result& result, Make make) {
  result = {};
  const auto fail = [&](std::int32_t error, const char* message) {
    result = {};
    std::snprintf(result.message, sizeof result.message, "%s", message);
    return error;
  };
  try {
    make();
    return DISCMC_MESH_OK;
  } catch (const Cancelled& error) {
    return fail(DISCMC_MESH_CANCELLED, error.what());
  } catch (const std::invalid_argument& error) {
    return fail(DISCMC_MESH_BAD_ARGUMENT, error.what());
  } catch (const std::length_error& error) {
    return fail(DISCMC_MESH_TOO_LARGE, error.what());
  } catch (const std::bad_alloc&) {
    return fail(DISCMC_MESH_NO_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return fail(DISCMC_MESH_FAILED, error.what());
  } catch (...) {
    return fail(DISCMC_MESH_FAILED, "the progress function threw an exception");
  }
}

}  // namespace
}  // namespace discmc::meshing

using namespace discmc;
using namespace discmc::meshing;

std::int32_t discmc_mesh_of(const discmc_samples* samples, double level_low, double level_high,
                            const discmc_mesh_options* options, discmc_mesh* mesh) {
  return result_of(*mesh, [&] {
    auto made = std::make_unique<Mesh>(
        mesh_of(samples_of(samples), Level(level_low, level_high), options_of(options)));
    *mesh = view_of(*made);
    mesh->owner = made.release();
  });
}

void discmc_mesh_free(discmc_mesh* mesh) {
  if (mesh == nullptr) return;
  delete static_cast<Mesh*>(mesh->owner);
  *mesh = {};
}

std::int32_t discmc_label_meshes_of(const discmc_samples* samples, const std::int64_t* labels,
                                    std::size_t label_count, const discmc_mesh_options* options,
                                    discmc_label_meshes* meshes) {
  return result_of(*meshes, [&] {
    if (labels == nullptr && label_count > 0)
      throw std::invalid_argument("the pointer to " + std::to_string(label_count) +
                                  " labels is null");
    auto made = std::make_unique<LabelMeshes>();
    const std::vector<std::int64_t> chosen(labels, labels + label_count);
    made->meshes = label_meshes(samples_of(samples), options_of(options), chosen);
    for (const LabelMesh& each : made->meshes)
      made->views.push_back({each.label, each.voxels, view_of(each.mesh)});
    meshes->count = made->views.size();
    meshes->meshes = made->views.data();
    meshes->owner = made.release();
  });
}

void discmc_label_meshes_free(discmc_label_meshes* meshes) {
  if (meshes == nullptr) return;
  delete static_cast<LabelMeshes*>(meshes->owner);
  *meshes = {};
}
