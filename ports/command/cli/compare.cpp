// discmc compare: the distance between two surfaces.
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "commands.hpp"
#include "empty_surface.hpp"
#include "extraction/classic.hpp"
#include "files/write_failure.hpp"
#include "mesh_files/file_mesh.hpp"
#include "mesh_files/mesh_reader.hpp"
#include "mesh_output.hpp"
#include "meshes/mesh.hpp"
#include "meshes/placing.hpp"
#include "meshes/surface_distance.hpp"
#include "progress.hpp"
#include "stream_input.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

struct Compared {
  FileMesh mesh;
  bool has_voxels;  ///< whether distances can be printed in voxels
  int code;
};

// Distances along turned axes are not multiples of the voxels.
bool lies_along_coordinates(const VolumePlacement& placement) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t other = 0; other < 3; ++other)
      if (axis != other && placement.axes_mm[axis][other] != 0) return false;
  return true;
}

// Places a surface as extract and decode place its mesh.
Compared placed(FileMesh mesh, const std::string& name,
                const std::optional<VolumePlacement>& declared, int code) {
  const auto placement = mesh_placement(name, declared, std::nullopt);
  if (placement) place(mesh, *placement);
  return {std::move(mesh), !placement || lies_along_coordinates(*placement), code};
}

Compared surface_of_volume(const std::string& name, VolumeArguments reading) {
  reading.selections = with_thresholds(name, reading);
  const auto volume = open_measured(name, reading);
  Progress progress("extracting", volume->info().dims[2]);
  FileMesh mesh = classic_mesh(*volume, extraction_options(reading, progress));
  if (mesh.face_count() == 0)
    throw std::runtime_error(why_empty(name, reading, reading.selections[0], *volume));
  return placed(std::move(mesh), name, volume->info().placement, exit_ok);
}

Compared surface_of_mesh(const std::string& name) {
  const Progress progress("reading");
  return {joined(read_meshes(name)), false, exit_ok};
}

Compared surface_of_stream(const std::string& name, const StreamChoice& choice) {
  const DecodedStream decoded = decode_surface(name, choice);
  const int code = completeness(name, decoded.report);
  const Progress progress("triangulating");
  return placed(build_mesh(decoded.surface, {true, Faces::triangles}), name, decoded.placement,
                code);
}

Compared surface_of(const ComparedInput& input, const CompareArguments& arguments) {
  if (input.kind == InputKind::mesh) return surface_of_mesh(input.name);
  if (input.kind == InputKind::stream) return surface_of_stream(input.name, arguments.choice);
  return surface_of_volume(input.name, arguments.reading);
}

Distances measured(const std::string& direction, const FileMesh& from, const FileMesh& to,
                   const Point& unit) {
  Progress progress("measuring " + direction, 100);
  return distances(from, to, unit, [&progress](std::size_t done, std::size_t all) {
    progress.show(100 * done / all);
  });
}

void print_row(const std::string& name, const Distances& distances) {
  std::cout << "  " << std::left << std::setw(20) << name << std::right << std::fixed
            << std::setprecision(4);
  for (const double distance : {distances.mean, distances.percentile_99, distances.largest})
    std::cout << std::setw(12) << distance;
  std::cout << '\n';
}

void print_distances(const Compared& a, const Compared& b, const Point& unit,
                     const std::string& unit_name) {
  print_row("A to B, " + unit_name, measured("A to B", a.mesh, b.mesh, unit));
  print_row("B to A, " + unit_name, measured("B to A", b.mesh, a.mesh, unit));
}

}  // namespace

int run_compare(const CompareArguments& arguments) {
  const Compared a = surface_of(arguments.inputs[0], arguments);
  const Compared b = surface_of(arguments.inputs[1], arguments);
  const Compared* const compared[] = {&a, &b};
  for (std::size_t i = 0; i < 2; ++i) {
    const FileMesh& mesh = compared[i]->mesh;
    if (mesh.face_count() == 0)
      throw std::invalid_argument(
          arguments.inputs[i].name +
          ": the surface is empty, so it has no distance; give one with triangles");
    if (!has_area(mesh))
      throw std::invalid_argument(
          arguments.inputs[i].name +
          ": no triangle has an area, so the mesh has no distance; give the mesh of a surface");
  }
  std::cout << "  " << std::left << std::setw(20) << "distances" << std::right << std::setw(12)
            << "mean" << std::setw(12) << "99 % within" << std::setw(12) << "largest" << '\n';
  print_distances(a, b, {1, 1, 1}, "mm");
  if (a.has_voxels || b.has_voxels)
    print_distances(a, b, (b.has_voxels ? b : a).mesh.spacing_mm, "voxels");
  require_written(std::cout);
  return a.code != exit_ok ? a.code : b.code;
}

}  // namespace discmc::command
