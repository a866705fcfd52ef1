#include "mesh_options.hpp"

#include <stdexcept>

#include "named_values.hpp"
#include "output_file.hpp"

namespace discmc::host {
namespace {

CLI::Validator known_format() {
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
                  "by extension .dmc, .obj, .ply, .stl or .jsonl; - is " + standard_output)
      ->check(known_format());
}

void add_normals_option(CLI::App& app, Normals& normals, const std::string& gradient) {
  app.option_defaults()->group(mesh_group);
  add_named_option(
      app, "--normals", normals,
      NamedValues<Normals>{
          {"none", Normals::none}, {"surface", Normals::surface}, {"gradient", Normals::gradient}},
      "at the vertices of a .ply or .obj mesh: none (default); surface: from the "
      "polygons that meet there, by area; gradient: " +
          gradient);
}

void add_conforming_option(CLI::App& app, bool& conforming) {
  app.option_defaults()->group(mesh_group);
  app.add_flag("--conforming,!--no-conforming", conforming,
               "a mesh without T-junctions (default), or corners alone");
}

void check_normals(Normals normals, const std::string& output, bool has_samples) {
  if (normals == Normals::none) return;
  const Format format = format_of(output);
  if (format == Format::ply || format == Format::obj) return;
  if (format == Format::stream && normals == Normals::gradient && has_samples) return;
  throw CLI::ValidationError(
      "--normals",
      format != Format::stream
          ? output + " cannot hold normals of vertices: give a .ply or .obj name"
      : has_samples ? "a stream holds normals of the gradient alone: give --normals gradient, or "
                      "a .ply or .obj name"
                    : "a stream keeps the normals that it has: leave it out, or give a .ply or "
                      ".obj name");
}

}  // namespace discmc::host
