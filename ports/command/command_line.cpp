#include "command_line.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "mesh_files/mesh_reader.hpp"
#include "option_checks.hpp"
#include "output_file.hpp"
#include "volumes/volume.hpp"

namespace discmc::host {
namespace {

// Checks of single values; what they return is an error, and wrong usage.

CLI::Validator finite() {
  return CLI::Validator(
      [](std::string& text) {
        const bool is_finite = !text.empty() && std::isfinite(std::strtod(text.c_str(), nullptr));
        return is_finite ? std::string() : "'" + text + "' is no finite number";
      },
      "");
}

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

CLI::Validator png_name() {
  return CLI::Validator(
      [](std::string& text) {
        const std::string extension = std::filesystem::path(text).extension().string();
        return text == "-" || extension == ".png" || extension == ".PNG"
                   ? std::string()
                   : text + ": pictures are PNG files: give a name that ends in .png";
      },
      "");
}

std::vector<CLI::Option*> add_choice(CLI::App& app, StreamChoice& choice) {
  return {app.add_option("--channel", choice.channel,
                         "the surface, of a stream or link that has several (default: the first)")
              ->check(CLI::Range(0, int{StreamLabel::max_channel}))
              ->option_text("N"),
          app.add_option("--scan", choice.scan,
                         "the scan, of a link that has carried several (default: the first)")
              ->check(CLI::Range(0, 65535))
              ->option_text("N")};
}

CLI::App* add_stream_command(CLI::App& app, const char* name, const char* description,
                             StreamArguments& arguments) {
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("STREAM", arguments.stream, "a .dmc file; - reads standard input")
      ->required();
  add_choice(*command, arguments.choice);
  return command;
}

CLI::Option* add_border(CLI::App& app, Border& border) {
  return app
      .add_option_function<std::string>(
          "--border",
          [&border](const std::string& name) {
            border = name == "open" ? Border::open : Border::closed;
          },
          "closed: off voxels all around; open: the surface ends at the outermost voxels")
      ->check(CLI::IsMember({"closed", "open"}))
      ->option_text("closed|open");
}

CLI::Option* add_type(CLI::App& app, std::optional<SampleType>& type) {
  return app
      .add_option_function<std::string>(
          "--type",
          [&type](const std::string& name) {
            type = name == "u8"    ? SampleType::u8
                   : name == "u16" ? SampleType::u16
                                   : SampleType::i16;
          },
          "samples of a headerless file")
      ->check(CLI::IsMember({"u8", "u16", "i16"}))
      ->option_text("u8|u16|i16");
}

// The layout of a headerless file but for its spacing, --dims first.
std::vector<CLI::Option*> add_layout(CLI::App& app, LayoutArguments& arguments) {
  CLI::Option* dims =
      app.add_option("--dims", arguments.dims, "extents of a headerless file, in voxels")
          ->delimiter(',')
          ->expected(3)
          ->option_text("X,Y,Z");
  CLI::Option* type = add_type(app, arguments.type);
  dims->needs(type);
  type->needs(dims);
  CLI::Option* big_endian =
      app.add_flag("--big-endian", arguments.big_endian, "byte order of a headerless file")
          ->needs(dims);
  return {dims, type, big_endian};
}

// All that says how a volume is read, --iso first.
std::vector<CLI::Option*> add_volume_options(CLI::App& app, VolumeArguments& arguments) {
  std::vector<CLI::Option*> options;
  options.push_back(app.add_option("--iso", arguments.isos,
                                   "on means value >= ISO, in the units that the file declares")
                        ->check(finite())
                        ->expected(1)
                        ->option_text("ISO"));
  options.push_back(add_border(app, arguments.border));
  CLI::Option* memory =
      add_memory_option(app, arguments.memory,
                        "bytes of the arena, with K or M for 1024 and 1024^2 (default: generous)");
  options.push_back(memory);
  options.push_back(app.add_option("--capacities", arguments.capacities,
                                   "records and holes that the arena has room for, in place of "
                                   "--memory")
                        ->delimiter(',')
                        ->expected(2)
                        ->option_text("RECORDS,HOLES")
                        ->excludes(memory));
  const std::vector<CLI::Option*> layout = add_layout(app, arguments.layout);
  options.insert(options.end(), layout.begin(), layout.end());
  options.push_back(app.add_option("--spacing", arguments.layout.spacing,
                                   "of a headerless file, in millimetres (default: 1,1,1)")
                        ->delimiter(',')
                        ->expected(3)
                        ->option_text("X,Y,Z")
                        ->check(usable_spacing())
                        ->needs(layout[0]));
  return options;
}

CLI::Option* add_output(CLI::App& app, std::string& output, const char* standard_output) {
  return app
      .add_option(
          "-o,--output", output,
          std::string("by extension .dmc, .obj, .ply, .stl or .jsonl; - is ") + standard_output)
      ->check(known_format());
}

void add_normals(CLI::App& app, Normals& normals, const std::string& gradient) {
  app.add_option_function<std::string>(
         "--normals",
         [&normals](const std::string& name) {
           normals = name == "surface"    ? Normals::surface
                     : name == "gradient" ? Normals::gradient
                                          : Normals::none;
         },
         "at the vertices of a .ply or .obj mesh: none (default); surface: from the polygons that "
         "meet there, by area; gradient: " +
             gradient)
      ->check(CLI::IsMember({"none", "surface", "gradient"}))
      ->option_text("none|surface|gradient");
}

// Only some formats hold normals of vertices.
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

// By the name; but what is given a threshold must be a volume.
InputKind kind_of(const std::string& input, bool has_iso) {
  if (is_mesh_name(input)) return InputKind::mesh;
  const bool is_stream = input == "-" || std::filesystem::path(input).extension() == ".dmc";
  return is_volume_name(input) || (has_iso && !is_stream) ? InputKind::volume : InputKind::stream;
}

void check_kind(const RenderArguments& arguments, const std::vector<CLI::Option*>& of_volumes) {
  if (arguments.kind == InputKind::volume) {
    if (of_volumes[0]->count() == 0)
      throw CLI::ValidationError(arguments.input,
                                 "a volume is drawn at a threshold: give --iso VALUE");
    return;
  }
  for (const CLI::Option* option : of_volumes)
    if (option->count() > 0)
      throw CLI::ValidationError(option->get_name(),
                                 "is for volumes, and " + arguments.input + " is " +
                                     (arguments.kind == InputKind::mesh ? "a mesh" : "a stream") +
                                     ": leave it out");
}

void check_isos(const ExtractArguments& arguments) {
  const std::size_t surfaces = arguments.reading.isos.size();
  if (surfaces > StreamHeader::max_surfaces)
    throw CLI::ValidationError("--iso", std::to_string(surfaces) + " surfaces are too many: give " +
                                            std::to_string(StreamHeader::max_surfaces) +
                                            " at most");
  if (surfaces > 1 && format_of(arguments.output) != Format::stream)
    throw CLI::ValidationError(
        "--iso", "several surfaces are a stream: give -o FILE.dmc, or one --iso for a mesh");
}

void check_wire(const ExtractArguments& arguments) {
  const bool is_of_slices = arguments.wire == Wire::slices;
  if (is_of_slices && format_of(arguments.output) != Format::stream)
    throw CLI::ValidationError("--wire", "slices are a stream: give -o FILE.dmc");
  if (is_of_slices && arguments.normals != Normals::none)
    throw CLI::ValidationError("--wire",
                               "a stream of slices holds no normals: leave out --normals");
  if (is_of_slices && (arguments.reading.memory > 0 || !arguments.reading.capacities.empty()))
    throw CLI::ValidationError("--wire",
                               "a slice encoder takes the memory that it needs, and no more: leave "
                               "out --memory and --capacities");
  if (!is_of_slices && arguments.key_slices > 0)
    throw CLI::ValidationError("--key-slices", "is of streams of slices: add --wire slices");
}

}  // namespace

void add_extract(CLI::App& app, ExtractArguments& arguments) {
  CLI::App* extract = app.add_subcommand("extract", "Extract the surface of a volume");
  extract
      ->add_option("VOLUME", arguments.volume,
                   "NRRD, NIfTI-1 or MetaImage file, or headerless samples with --dims and --type")
      ->required();
  add_volume_options(*extract, arguments.reading)[0]
      ->required()
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->description(
          "on means value >= ISO, in the units that the file declares; given up to 4 "
          "times: a surface each, on channels of the stream");
  add_output(*extract, arguments.output, "the stream on standard output (default)");
  add_normals(*extract, arguments.normals,
              "from the samples of the volume, and what a .dmc stream can hold");
  extract
      ->add_option_function<std::string>(
          "--wire",
          [&arguments](const std::string& name) {
            arguments.wire = name == "slices" ? Wire::slices : Wire::regions;
          },
          "what a .dmc stream holds: regions (default), final as they come; or slices, the bits of "
          "the volume, in a tenth of the bytes")
      ->check(CLI::IsMember({"regions", "slices"}))
      ->option_text("regions|slices");
  extract
      ->add_option("--key-slices", arguments.key_slices,
                   "with --wire slices: every N slices one that needs none before it, for who has "
                   "lost some (default: the first alone)")
      ->check(CLI::Range(std::uint32_t{1}, Limits::max_slices))
      ->option_text("N");
  extract
      ->add_option(
          "--scan", arguments.scan,
          "a number for the scan, by which streams on one link are told apart (default: 0)")
      ->option_text("N");
  extract->add_flag("--conforming,!--no-conforming", arguments.conforming,
                    "a mesh without T-junctions (default), or corners alone");
  extract->add_flag("-q,--quiet", arguments.quiet, "no table");
  extract->callback([&arguments] {
    check_normals(arguments.normals, arguments.output, true);
    check_isos(arguments);
    check_wire(arguments);
  });
}

void add_stream_commands(CLI::App& app, StreamArguments& arguments) {
  CLI::App* decode =
      add_stream_command(app, "decode", "Turn a stream into a mesh, or pack it anew", arguments);
  add_output(*decode, arguments.output, "a stream on standard output")->required();
  add_normals(*decode, arguments.normals,
              "those that the stream tells, or from the samples of --volume");
  CLI::Option* volume = decode->add_option("--volume", arguments.volume,
                                           "the file that the stream was made of, for --normals "
                                           "gradient (default: what the stream tells of it)");
  add_layout(*decode, arguments.layout)[0]->needs(volume);
  decode->add_flag("--conforming,!--no-conforming", arguments.conforming,
                   "a mesh without T-junctions (default), or corners alone");
  decode->callback([&arguments] {
    check_normals(arguments.normals, arguments.output, false);
    if (!arguments.volume.empty() && arguments.normals != Normals::gradient)
      throw CLI::ValidationError("--volume", "is read for its gradient: add --normals gradient");
  });
  add_stream_command(app, "info", "Tell what a stream holds, one key and value a line", arguments);
}

void add_render(CLI::App& app, RenderArguments& arguments) {
  CLI::App* render =
      app.add_subcommand("render", "Draw a stream, a mesh or a volume as a PNG picture");
  render
      ->add_option("INPUT", arguments.input,
                   "a .dmc stream (- reads standard input), a .ply, .obj or .stl mesh, or a volume "
                   "as extract takes it")
      ->required();
  render->add_option("-o,--output", arguments.output, "the PNG file; - is standard output")
      ->check(png_name())
      ->required();
  render->add_option("--view", arguments.view, "direction from the surface to the viewer")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->option_text("X,Y,Z");
  render->add_option("--size", arguments.size, "of the picture, in pixels (default: 1024,1024)")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1, 8192))
      ->option_text("W,H");
  render->add_option("--zoom", arguments.zoom, "times nearer than what shows all (default: 1)")
      ->check(finite())
      ->check(CLI::Range(1e-3, 1e3))
      ->option_text("FACTOR");
  render
      ->add_option("--at", arguments.at,
                   "the point in the middle of the picture, in millimetres as in meshes")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->option_text("X,Y,Z");
  render
      ->add_option_function<std::string>(
          "--shade", [&arguments](const std::string& name) { arguments.smooth = name == "smooth"; },
          "flat: every face in one colour (default); smooth: by the normals of vertices")
      ->check(CLI::IsMember({"flat", "smooth"}))
      ->option_text("flat|smooth");
  render->add_flag("--edges", arguments.outlines,
                   "outline the faces: of a stream or a volume its merged polygons");
  const std::vector<CLI::Option*> choice = add_choice(*render, arguments.choice);
  std::vector<CLI::Option*> of_volumes = add_volume_options(*render, arguments.reading);
  of_volumes.push_back(
      render
          ->add_flag(
              "--classic", arguments.classic,
              "triangles of classic Marching Cubes, with interpolated vertices, for comparison")
          ->excludes("--memory")
          ->excludes("--capacities"));
  render->callback([&arguments, of_volumes, choice] {
    arguments.kind = kind_of(arguments.input, of_volumes[0]->count() > 0);
    check_kind(arguments, of_volumes);
    for (const CLI::Option* option : choice)
      if (arguments.kind != InputKind::stream && option->count() > 0)
        throw CLI::ValidationError(option->get_name(), "is for streams: leave it out");
    if (arguments.view == std::vector<double>{0, 0, 0})
      throw CLI::ValidationError("--view", "0,0,0 is no direction: give one that is not zero");
  });
}

}  // namespace discmc::host
