#include "finished_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <thread>
#include <utility>

#include "decimation/decimation.hpp"
#include "extraction/narrowed_volume.hpp"
#include "jobs/parallel.hpp"
#include "jobs/processors.hpp"
#include "meshes/outline.hpp"
#include "meshes/placing.hpp"
#include "meshes/plane_mesh.hpp"
#include "meshes/surface_normals.hpp"
#include "meshes/vertex_normals.hpp"
#include "meshes/vertex_numbers.hpp"
#include "samples/sample_bounds.hpp"
#include "smoothing/relaxed_crossings.hpp"

namespace discmc::meshing {
namespace {

Decimation decimation_of(const MeshOptions& options) {
  return {options.triangles, options.max_error};
}

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument(text);
}

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

std::string text_of(const std::array<double, 3>& numbers) {
  return text_of(numbers[0]) + ", " + text_of(numbers[1]) + ", " + text_of(numbers[2]);
}

void require_number(const char* name, double value) {
  if (!(value >= 0) || std::isinf(value))
    refuse(std::string(name) + " is " + text_of(value) + "; give 0 or more");
}

void add_gradient(FaceMesh& mesh, const MeshOptions& options, double level,
                  const OpenAgain& open_again) {
  std::unique_ptr<SliceReader> volume = open_again();
  const SampleGrid info = volume->info();
  if (!is_scanner_type(info.type)) {
    const SampleBounds bounds = sample_bounds(*volume);
    volume = narrowed(open_again(), bounds, level);
  }
  set_gradient_normals(*volume, mesh, [&](std::uint32_t slices) {
    report(options, "normals", slices, info.dims[2]);
  });
}

void add_normals(const Surface& surface, FaceMesh& mesh, const MeshOptions& options, double level,
                 const OpenAgain& open_again) {
  if (options.normals == Normals::none || mesh.vertices_mm.empty()) return;
  report(options, "normals", 0, 0);
  if (mesh.polygons.empty() || is_interpolated(options) || options.relaxes)
    mesh.normals = surface_normals(mesh);
  else
    set_polygon_normals(surface, mesh);
  if (options.normals == Normals::gradient) add_gradient(mesh, options, level, open_again);
  for (Point& normal : mesh.normals) normal = unit_or_zero(normal);  // streams have 15 bits
}

// vertices: the vertices of the mesh, by their VertexNumbers.
MeshPolygons polygons_of(const Surface& surface, const std::vector<Point>& vertices,
                         bool is_mirrored, unsigned threads) {
  MeshPolygons polygons;
  const VertexNumbers numbers(surface.polygons, threads);
  for (const Polygon& polygon : surface.polygons) {
    const std::size_t outer = polygons.corner_begin.back();
    for (const Ring& ring : polygon.rings) {
      const std::size_t begin = polygons.corner_begin.back();
      for (const Vertex& corner : ring) polygons.corners.push_back(numbers.find(corner));
      polygons.corner_begin.push_back(begin + ring.size());
      const auto first = polygons.corners.begin() + static_cast<std::ptrdiff_t>(begin);
      if (is_mirrored) std::reverse(first, first + static_cast<std::ptrdiff_t>(ring.size()));
    }
    polygons.ring_begin.push_back(polygons.ring_begin.back() + polygon.rings.size());
    polygons.normals.push_back(unit_or_zero(
        area_vector(vertices, polygons.corners.data() + outer, polygon.rings[0].size())));
  }
  return polygons;
}

MeshingOptions triangle_options(const MeshOptions& options) {
  MeshingOptions meshing;
  meshing.faces = Faces::triangles;
  meshing.tolerance = options.tolerance;
  meshing.jobs = threads_of(options);
  meshing.check = [report_here = reporter_here(options, "triangulating", 0)] { report_here(0); };
  return meshing;
}

// Makes the triangles of polygons that stay in their planes, straight into the arrays of the mesh.
Mesh plane_triangles(const Surface& surface, const MeshOptions& options, const SweepAxes& axes) {
  const VertexNumbers vertices(surface.polygons, threads_of(options));
  std::optional<Placing> placing;
  if (axes.placement) placing.emplace(axes.spacing, *axes.placement);
  Mesh mesh;
  mesh.vertices.resize(vertices.size());
  for_each_in_parallel(threads_of(options), vertices.part_count(), [&](std::size_t part) {
    vertices.for_each(part, [&](std::uint32_t number, const Vertex& vertex) {
      const Point at = in_mm(point_of(vertex), axes.spacing);
      mesh.vertices[number] = placing ? placing->vertex(at) : at;
    });
  });
  const bool reverses = placing && placing->mirrors();
  mesh.triangles.reserve(likely_faces(vertices.size()));
  for_each_face_block(surface, vertices, triangle_options(options), [&](const FaceMesh& block) {
    for (std::size_t i = 0; i < block.corners.size(); i += 3) {
      const std::uint32_t* const corners = &block.corners[i];
      mesh.triangles.push_back({corners[reverses ? 2 : 0], corners[1], corners[reverses ? 0 : 2]});
    }
  });
  return mesh;
}

// Likewise makes a mesh that is interpolated, decimated or has normals.
Mesh processed_mesh(const Surface& surface, const Crossings* crossings, const MeshOptions& options,
                    const SweepAxes& axes, double level, const OpenAgain& open_again) {
  MeshingOptions meshing = triangle_options(options);
  meshing.crossings = crossings;
  FaceMesh faces = build_mesh(surface, meshing);
  if (decimation_of(options).is_wanted())
    decimate(faces, decimation_of(options), [&options] { report(options, "decimating", 0, 0); });
  add_normals(surface, faces, options, level, open_again);
  if (axes.placement) meshing::place(faces, *axes.placement);

  Mesh mesh;
  mesh.vertices = std::move(faces.vertices_mm);
  mesh.normals = std::move(faces.normals);
  mesh.triangles.resize(faces.face_count());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    std::copy_n(faces.face(i), 3, mesh.triangles[i].begin());
  return mesh;
}

}  // namespace

void report(const MeshOptions& options, const char* step, std::uint64_t done, std::uint64_t total) {
  if (options.progress && !options.progress({step, done, total})) throw Cancelled();
}

std::function<void(std::uint64_t)> reporter_here(const MeshOptions& options, const char* step,
                                                 std::uint64_t total) {
  return [&options, step, total, here = std::this_thread::get_id()](std::uint64_t done) {
    if (std::this_thread::get_id() == here) report(options, step, done, total);
  };
}

unsigned threads_of(const MeshOptions& options) {
  return options.threads > 0 ? options.threads : processors();
}

bool is_interpolated(const MeshOptions& options) {
  return options.interpolates || options.smoothing > 0;
}

Selection selection_of(const Level& level) {
  if (std::isnan(level.low) || std::isnan(level.high)) refuse("the level is nan; give a number");
  if (level.low > level.high)
    refuse("the level is from " + text_of(level.low) + " to " + text_of(level.high) +
           "; give numbers in this order");
  return {level.low, level.high};
}

SweepAxes sweep_axes(const MeshOptions& options, const AxisOrder& order) {
  VolumePlacement placement{Space::scanner, {}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    placement.axes_mm[axis][axis] = options.spacing[axis];
    if (!options.placement) continue;
    placement.origin_mm[axis] = (*options.placement)[axis][3];
    for (std::size_t row = 0; row < 3; ++row)
      placement.axes_mm[axis][row] = (*options.placement)[row][axis];
  }
  const auto& origin = placement.origin_mm;
  if (!std::all_of(origin.begin(), origin.end(),
                   [](double at) { return std::fabs(at) <= max_origin_mm; }))
    refuse("the origin of the placement is " + text_of(origin) +
           "; give coordinates of -1e9 to 1e9");
  if (!is_usable(placement))
    refuse(options.placement
               ? "the columns of the placement span no space, or are not 1e-6 to 1e6 long"
               : "the spacing is " + text_of(options.spacing) + "; give distances of 1e-6 to 1e6");
  VolumePlacement swept = placement;
  for (std::size_t axis = 0; axis < 3; ++axis) swept.axes_mm[axis] = placement.axes_mm[order[axis]];
  const bool is_mirrored = determinant(swept.axes_mm) < 0;
  if (!options.placement && order == AxisOrder{0, 1, 2})
    return {options.spacing, std::nullopt, is_mirrored};
  SweepAxes axes{{}, swept, is_mirrored};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::array<double, 3>& along = swept.axes_mm[axis];
    axes.spacing[axis] = std::hypot(along[0], along[1], along[2]);
  }
  return axes;
}

void check_options(const MeshOptions& options) {
  require_number("tolerance", options.tolerance);
  require_number("smoothing", options.smoothing);
  constexpr double max_smoothing = 1e6;
  if (options.smoothing > max_smoothing)
    refuse("smoothing is " + text_of(options.smoothing) + "; give 0 to 1e6");
  require_number("max_error", options.max_error);
  const bool leaves_midpoints = is_interpolated(options) || options.relaxes;
  if (options.polygons && (decimation_of(options).is_wanted() || leaves_midpoints))
    refuse(
        "polygons are those of the midpoint surface: leave out interpolation, relaxation, "
        "smoothing and decimation, or the polygons");
  if (options.relaxes && is_interpolated(options))
    refuse("relaxation uses no samples: leave it out, or interpolation and smoothing");
}

Mesh finished_mesh(Surface& surface, Crossings* crossings, const MeshOptions& options,
                   const SweepAxes& axes, double level, const OpenAgain& open_again) {
  surface.spacing_mm = axes.spacing;
  if (options.relaxes)
    relax(*crossings, surface,
          {options.border, options.tolerance, [&options] { report(options, "smoothing", 0, 0); }});
  report(options, "triangulating", 0, 0);
  const bool is_plane = crossings == nullptr && !decimation_of(options).is_wanted() &&
                        options.normals == Normals::none;
  Mesh mesh = is_plane ? plane_triangles(surface, options, axes)
                       : processed_mesh(surface, crossings, options, axes, level, open_again);
  if (options.polygons)
    mesh.polygons = polygons_of(surface, mesh.vertices, axes.is_mirrored, threads_of(options));
  return mesh;
}

}  // namespace discmc::meshing
