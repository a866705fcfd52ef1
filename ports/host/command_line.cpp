#include "command_line.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "option_checks.hpp"
#include "output_file.hpp"

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

CLI::App* add_stream_command(CLI::App& app, const char* name, const char* description,
                             StreamArguments& arguments) {
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("STREAM", arguments.stream, "a .dmc file; - reads standard input")
      ->required();
  return command;
}

}  // namespace

void add_extract(CLI::App& app, ExtractArguments& arguments) {
  CLI::App* extract = app.add_subcommand("extract", "Extract the surface of a volume");
  extract
      ->add_option("VOLUME", arguments.volume,
                   "NRRD, NIfTI-1 or MetaImage file, or headerless samples with --dims and --type")
      ->required();
  extract
      ->add_option("--iso", arguments.iso,
                   "on means value >= ISO, in the units that the file declares")
      ->check(finite())
      ->required();
  extract
      ->add_option_function<std::string>(
          "--border",
          [&arguments](const std::string& name) {
            arguments.border = name == "open" ? Border::open : Border::closed;
          },
          "closed: off voxels all around; open: the surface ends at the outermost voxels")
      ->check(CLI::IsMember({"closed", "open"}))
      ->option_text("closed|open");
  add_memory_option(*extract, arguments.memory,
                    "bytes of the arena, with K or M for 1024 and 1024^2 (default: generous)");
  extract
      ->add_option("-o,--output", arguments.output,
                   "by extension .dmc, .obj, .ply, .stl or .jsonl; - is the stream on standard "
                   "output (default)")
      ->check(known_format());
  CLI::Option* dims =
      extract->add_option("--dims", arguments.dims, "extents of a headerless file, in voxels")
          ->delimiter(',')
          ->expected(3)
          ->option_text("X,Y,Z");
  CLI::Option* type = extract
                          ->add_option_function<std::string>(
                              "--type",
                              [&arguments](const std::string& name) {
                                arguments.type = name == "u8"    ? SampleType::u8
                                                 : name == "u16" ? SampleType::u16
                                                                 : SampleType::i16;
                              },
                              "samples of a headerless file")
                          ->check(CLI::IsMember({"u8", "u16", "i16"}))
                          ->option_text("u8|u16|i16");
  dims->needs(type);
  type->needs(dims);
  extract->add_flag("--big-endian", arguments.big_endian, "byte order of a headerless file")
      ->needs(dims);
  extract
      ->add_option("--spacing", arguments.spacing,
                   "of a headerless file, in millimetres (default: 1,1,1)")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z")
      ->check(usable_spacing())
      ->needs(dims);
  extract->add_flag("--conforming,!--no-conforming", arguments.conforming,
                    "a mesh without T-junctions (default), or corners alone");
  extract->add_flag("-q,--quiet", arguments.quiet, "no table");
}

void add_stream_commands(CLI::App& app, StreamArguments& arguments) {
  CLI::App* decode =
      add_stream_command(app, "decode", "Turn a stream into a mesh, or pack it anew", arguments);
  decode
      ->add_option(
          "-o,--output", arguments.output,
          "by extension .dmc, .obj, .ply, .stl or .jsonl; - is a stream on standard output")
      ->check(known_format())
      ->required();
  decode->add_flag("--conforming,!--no-conforming", arguments.conforming,
                   "a mesh without T-junctions (default), or corners alone");
  add_stream_command(app, "info", "Tell what a stream holds, one key and value a line", arguments);
  CLI::App* render = add_stream_command(app, "render", "Draw a stream as a PNG picture", arguments);
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
  render->add_flag("--edges", arguments.outlines, "outline the merged polygons");
}

}  // namespace discmc::host
