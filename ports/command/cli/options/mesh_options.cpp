#include "mesh_options.hpp"

#include <stdexcept>

#include "files/output_file.hpp"
#include "mesh_files/file_format.hpp"
#include "named_values.hpp"
#include "option_checks.hpp"

namespace discmc::command {
namespace {

// Example: "out.stl", or ".stl on standard output".
std::string named(const std::string& output) {
  if (!is_standard_output(output)) return output;
  return std::string(traits_of(format_of(output)).extension) + " on standard output";
}

// Suggests formats to use instead.
std::string other_format(const std::string& output, bool FormatTraits::*holds) {
  return is_standard_output(output) ? "--format " + extensions(holds)
                                    : "a " + extensions(holds) + " name";
}

CLI::Validator mesh_format() {
  return CLI::Validator(
      [](std::string& text) {
        try {
          format_of(text);
        } catch (const std::invalid_argument& error) {
          return std::string(error.what());
        }
        return std::string();
      },
      "");
}

}  // namespace

CLI::Option* add_output_option(CLI::App& app, std::string& output,
                               const std::string& standard_output) {
  return app
      .add_option("-o,--output", output,
                  "the file to write; its extension chooses the format: " + extensions() +
                      "; - is " + standard_output)
      ->check(mesh_format());
}

void add_format_option(CLI::App& app, std::string& format) {
  app.add_option("--format", format, "the format of standard output (with -o -), such as stl")
      ->check(CLI::Validator(
          [](std::string& text) {
            const std::string name = text.rfind('.', 0) == 0 ? text.substr(1) : text;
            const bool is_format =
                name.find('.') == std::string::npos && mesh_format()("-." + name).empty();
            return is_format ? std::string()
                             : "'" + text + "' is not a format; expected " + extensions();
          },
          ""))
      ->option_text("stl|ply|...");
}

void add_format_to_name(const std::string& format, std::string& output) {
  if (format.empty()) return;
  if (output != "-")
    refuse("--format", "is for standard output; leave it out, as " + output +
                           " has an extension, or give -o -");
  output += (format[0] == '.' ? "" : ".") + format;
}

void add_normals_option(CLI::App& app, Normals& normals, const std::string& gradient) {
  app.option_defaults()->group(mesh_group);
  add_named_option(
      app, "--normals", normals,
      NamedValues<Normals>{
          {"none", Normals::none}, {"surface", Normals::surface}, {"gradient", Normals::gradient}},
      "write normals of vertices (" + extensions(&FormatTraits::holds_normals) +
          "); surface: from the faces around a vertex; gradient: " + gradient);
}

void add_mesh_options(CLI::App& app, MeshingOptions& mesh) {
  app.option_defaults()->group(mesh_group);
  add_named_option(
      app, "--faces", mesh.faces,
      NamedValues<Faces>{{"triangles", Faces::triangles}, {"polygons", Faces::polygons}},
      "triangles: for every program; polygons: the merged polygons, with up to " +
          std::to_string(max_face_corners) + " corners, for programs that accept concave n-gons");
  app.add_flag(
      "--conforming,!--no-conforming", mesh.is_conforming,
      "write a mesh without T-junctions (default), or with fewer vertices and with T-junctions");
}

void add_component_options(CLI::App& app, ComponentChoice& components) {
  app.option_defaults()->group(mesh_group);
  app.add_option(
         "--largest", components.largest,
         "keep the N bodies that enclose the most volume, with their cavities (default: all)")
      ->check(whole_from(1))
      ->option_text("N");
  app.add_option("--min-volume", components.min_volume_mm3,
                 "drop bodies and cavities that enclose less than MM3 cubic millimetres")
      ->check(accepted([](double volume) { return volume >= 0; }, "cubic millimetres, 0 or more"))
      ->option_text("MM3");
  app.add_flag("--fill", components.fills,
               "fill the cavities: enclosed hollows, with the bodies inside them");
}

void check_components(const ComponentChoice& components, const std::string& output) {
  if (components.keeps_all() || format_of(output) != Format::stream) return;
  refuse(components.largest > 0 ? "--largest"
         : components.fills     ? "--fill"
                                : "--min-volume",
         "a stream is written before its surface is complete; write a mesh, or leave it out");
}

void check_closed(const ComponentChoice& components, Border border) {
  if (components.keeps_all() || border == Border::closed) return;
  refuse("--border",
         "an open surface encloses no volume; leave out --largest, --min-volume and --fill, or "
         "--border open");
}

void add_space_option(CLI::App& app, std::optional<MeshSpace>& space) {
  app.option_defaults()->group(mesh_group);
  add_named_option(
      app, "--space", space,
      NamedValues<MeshSpace>{
          {"lps", MeshSpace::lps}, {"ras", MeshSpace::ras}, {"voxel", MeshSpace::voxel}},
      "the coordinates of a mesh; lps, ras: of the patient, from the origin and axes of the "
      "volume, "
      "as in DICOM and in NIfTI; voxel: voxel index times spacing (default: lps if the file has an "
      "orientation, otherwise the "
      "coordinates of the file)");
}

void check_space(const std::optional<MeshSpace>& space, const std::string& output) {
  const Format format = format_of(output);
  if (!space || (format != Format::stream && format != Format::jsonl)) return;
  refuse("--space",
         named(output) +
             (format == Format::stream ? " is a stream, which stores the placement as a record"
                                       : " has coordinates in half-steps of voxels") +
             "; leave it out, or write a mesh");
}

void add_size_options(CLI::App& app, MeshSize& size) {
  app.option_defaults()->group(mesh_group);
  add_named_option(app, "--unit", size.unit,
                   NamedValues<MeshUnit>{{"mm", MeshUnit::millimetre},
                                         {"um", MeshUnit::micrometre},
                                         {"m", MeshUnit::metre},
                                         {"inch", MeshUnit::inch}},
                   "unit of the coordinates in the file; .3mf also states it");
  app.add_option("--scale", size.scale, "make the mesh FACTOR times as large")
      ->check(
          accepted([](double factor) { return factor >= 1e-6 && factor <= 1e6; }, "1e-6 to 1e6"))
      ->option_text("FACTOR")
      ->capture_default_str();
}

void check_size(const MeshSize& size, const std::string& output) {
  if (!size.is_given()) return;
  const FormatTraits& traits = traits_of(format_of(output));
  const std::string option = size.scale != 1 ? "--scale" : "--unit";
  if (traits.format == Format::stream || traits.format == Format::jsonl || traits.holds_measures)
    refuse(option, named(output) + " has a fixed unit; write a mesh");
  if (traits.format == Format::glb && size.unit != MeshUnit::millimetre)
    refuse("--unit", named(output) + " is in metres, as its format requires; leave out --unit");
}

void add_surface_kind_options(CLI::App& app, SurfaceKind& surface, double& tolerance,
                              const std::string& interpolated) {
  app.option_defaults()->group(mesh_group);
  add_named_option(app, "--surface", surface,
                   NamedValues<SurfaceKind>{{"merged", SurfaceKind::merged},
                                            {"interpolated", SurfaceKind::interpolated},
                                            {"relaxed", SurfaceKind::relaxed}},
                   "where the vertices lie; merged: halfway between voxels, in flat polygons; "
                   "interpolated: where the samples cross the threshold, as in classic Marching "
                   "Cubes" +
                       interpolated +
                       "; relaxed: on the smoothest surface between the voxels, which needs no "
                       "samples");
  app.add_option("--tolerance", tolerance,
                 "the largest distance of an interpolated or relaxed surface from these places, in "
                 "voxels; less needs more triangles" +
                     std::string(interpolated.empty()
                                     ? ""
                                     : "; 0 is the default with --triangles or --max-error"))
      ->check(finite())
      ->check(not_negative())
      ->option_text("VOXELS")
      ->capture_default_str();
}

void add_decimation_options(CLI::App& app, Decimation& decimation) {
  app.option_defaults()->group(mesh_group);
  app.add_option(
         "--triangles", decimation.triangles,
         "decimate each mesh to N triangles; closed meshes stay closed, and bodies keep their "
         "volumes (default: all triangles)")
      ->check(whole_from(4))
      ->option_text("N");
  app.add_option("--max-error", decimation.max_error_mm,
                 "decimate each mesh. Its vertices and middles stay within MM millimetres of the "
                 "original, and the vertices of the original within MM of it")
      ->check(accepted([](double length) { return length > 0; }, "millimetres above 0"))
      ->option_text("MM");
}

void check_decimation(const Decimation& decimation, const MeshingOptions& mesh,
                      const std::string& output) {
  if (!decimation.is_wanted()) return;
  const std::string option = decimation.triangles > 0 ? "--triangles" : "--max-error";
  const Format format = format_of(output);
  if (format == Format::stream || format == Format::jsonl)
    refuse(option, named(output) + " holds merged polygons, which are not decimated; write a mesh");
  if (mesh.faces == Faces::polygons || !mesh.is_conforming)
    refuse(option,
           "only triangles without T-junctions are decimated; leave out --faces polygons and "
           "--no-conforming");
}

void check_surface_kind(SurfaceKind surface, const MeshingOptions& mesh,
                        const std::string& output) {
  if (surface == SurfaceKind::merged) return;
  const std::string name = surface == SurfaceKind::interpolated ? "interpolated" : "relaxed";
  const Format format = format_of(output);
  if (format == Format::stream || format == Format::jsonl)
    refuse("--surface", named(output) +
                            " has vertices halfway between voxels; leave out --surface " + name +
                            ", or write a mesh");
  if (mesh.faces == Faces::polygons)
    refuse("--faces",
           "polygons of a surface that is " + name + " are not flat; leave out --faces polygons");
  if (!mesh.is_conforming)
    refuse("--no-conforming", "a surface that is " + name + " has no T-junctions; leave it out");
}

void check_tolerance(SurfaceKind surface, const CLI::App& app) {
  if (app.get_option("--tolerance")->count() > 0 && surface == SurfaceKind::merged)
    refuse("--tolerance",
           "applies to interpolated and relaxed surfaces; add --surface interpolated or --surface "
           "relaxed");
}

void check_faces(Faces faces, const std::string& output) {
  if (faces == Faces::triangles || traits_of(format_of(output)).holds_polygons) return;
  refuse("--faces", named(output) + " cannot hold polygons; leave it out, or give " +
                        other_format(output, &FormatTraits::holds_polygons));
}

void check_normals(Normals normals, const std::string& output, bool has_samples) {
  if (normals == Normals::none) return;
  const Format format = format_of(output);
  if (traits_of(format).holds_normals) return;
  if (format == Format::stream && normals == Normals::gradient && has_samples) return;
  const std::string other = other_format(output, &FormatTraits::holds_normals);
  refuse(
      "--normals",
      (format != Format::stream ? named(output) + " cannot hold normals; give "
       : has_samples ? "a stream holds only normals of the gradient; give --normals gradient, or "
                     : "a stream keeps its normals; leave it out, or give ") +
          other);
}

}  // namespace discmc::command
