// The discmc command.
#include <unistd.h>

#include <discmc/shared_output.hpp>
#include <discmc/slice_encoder.hpp>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "extraction/classic.hpp"
#include "extraction/extraction.hpp"
#include "mesh_files/mesh_reader.hpp"
#include "meshes/mesh.hpp"
#include "meshes/surface_normals.hpp"
#include "meshes/vertex_normals.hpp"
#include "output_file.hpp"
#include "pictures/picture.hpp"
#include "progress.hpp"
#include "streams/application_text.hpp"
#include "streams/stream_file.hpp"
#include "summary.hpp"
#include "surface/counts.hpp"
#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"
#include "volumes/volume.hpp"

namespace discmc::host {
namespace {

constexpr int exit_ok = 0;
constexpr int exit_failure = 1;
constexpr int exit_usage = 2;
constexpr int exit_incomplete = 3;

void require(Status status) {
  if (status != Status::ok) throw std::runtime_error(text(status));
}

// Gives every event to the encoder and, joined, to the surface.
struct Tee {
  NormalEncoder encoder;
  SurfaceBuilder builder;
  GrowingJoiner joiner{sink_to(builder)};
  Answer take(const Event& event) {
    if (encoder.take(event) != Answer::taken) return Answer::not_now;
    return joiner.take(event);
  }
};

// Tells the bits of a volume, in memory of its own.
class SliceWriter {
 public:
  void start(const StreamHeader& header, KeySlices key_slices, const ByteOutput& output) {
    memory_.resize(
        slice_encoder_bytes({header.width, header.height}, key_slices, header.surfaces()));
    require(encoder_.start(header, key_slices, {memory_.data(), memory_.size()}, output));
  }
  SliceEncoder& encoder() { return encoder_; }

 private:
  std::vector<std::uint8_t> memory_;
  SliceEncoder encoder_;
};

std::optional<RawLayout> raw_layout(const LayoutArguments& arguments) {
  if (arguments.dims.empty()) return std::nullopt;
  RawLayout layout;
  std::copy_n(arguments.dims.begin(), 3, layout.dims.begin());
  layout.type = *arguments.type;
  layout.big_endian = arguments.big_endian;
  if (!arguments.spacing.empty())
    std::copy_n(arguments.spacing.begin(), 3, layout.spacing_mm.begin());
  return layout;
}

void require_written(std::ostream& out) {
  if (!out.flush()) throw std::runtime_error("the table cannot be written: is the disk full?");
}

// Writes a surface to the file; what goes wrong is told with its name.
void write_surface(const Surface& surface, Format format, bool conforming,
                   const std::function<void(Mesh&)>& add_normals, OutputFile& file) {
  try {
    write_surface(surface, format, conforming, add_normals, file.stream());
  } catch (const std::runtime_error&) {
    if (!file.stream()) file.commit();  // throws
    throw;
  }
}

// A second pass over the volume of a mesh.
void add_gradient_normals(VolumeReader& volume, Mesh& mesh) {
  Progress progress("normals: slice", volume.info().dims[2]);
  set_gradient_normals(volume, mesh, [&progress](std::uint32_t slices) { progress.show(slices); });
}

// Opens the volume, and says what of its file is dropped.
std::unique_ptr<VolumeReader> open_noted_volume(const std::string& path,
                                                const VolumeArguments& arguments) {
  auto volume = open_volume(path, raw_layout(arguments.layout));
  for (const std::string& note : volume->info().notes)
    std::cerr << "discmc: " << path << ": " << note << '\n';
  return volume;
}

ExtractionOptions extraction_options(const VolumeInfo& info, const VolumeArguments& arguments,
                                     Progress& progress) {
  ExtractionOptions options;
  options.threshold = stored_threshold(info, arguments.isos[0]);
  options.border = arguments.border;
  options.memory = arguments.memory;
  if (!arguments.capacities.empty())
    options.capacities = Capacities{arguments.capacities[0], arguments.capacities[1]};
  options.progress = [&progress](std::uint32_t slices) { progress.show(slices); };
  return options;
}

void add_normals(const ExtractArguments& arguments, const Surface& surface, Mesh& mesh) {
  if (arguments.normals == Normals::none) return;
  set_polygon_normals(surface, mesh);
  if (arguments.normals == Normals::surface) return;
  const auto again = open_volume(arguments.volume, raw_layout(arguments.reading.layout));
  add_gradient_normals(*again, mesh);
}

// The surfaces of a volume on their way to streams, and joined for the table or a mesh.
class Surfaces {
 public:
  Surfaces(const VolumeInfo& info, const ExtractArguments& arguments) {
    for (const double iso : arguments.reading.isos) {
      thresholds_.push_back(stored_threshold(info, iso));
      tees_.push_back(std::make_unique<Tee>());
    }
  }

  /// Begins a stream of regions for each.
  void start(StreamLabel label, const ByteOutput& output) {
    link_.start(output);
    for (std::size_t i = 0; i < tees_.size(); ++i) {
      label.channel = static_cast<std::uint8_t>(i);
      require(tees_[i]->encoder.start(label, link_.output()));
    }
  }
  /// The header of a stream of slices that holds all of them. header: that of the first.
  StreamHeader header_of_all(StreamHeader header) const {
    header.further_surfaces = static_cast<std::uint8_t>(thresholds_.size() - 1);
    std::copy(thresholds_.begin() + 1, thresholds_.end(), header.further_thresholds);
    return header;
  }
  std::vector<SurfaceRequest> requests() {
    std::vector<SurfaceRequest> requests;
    for (std::size_t i = 0; i < tees_.size(); ++i)
      requests.push_back({thresholds_[i], sink_to(*tees_[i])});
    return requests;
  }

  std::size_t count() const { return tees_.size(); }
  Tee& operator[](std::size_t surface) { return *tees_[surface]; }

 private:
  std::vector<std::int32_t> thresholds_;
  std::vector<std::unique_ptr<Tee>> tees_;
  SharedOutput link_;
};

int run_extract(const ExtractArguments& arguments) {
  const Format format = format_of(arguments.output);
  if (arguments.output == "-" && isatty(STDOUT_FILENO) == 1)
    throw std::invalid_argument("a stream is not written to a terminal: give -o FILE, or a pipe");
  const auto volume = open_noted_volume(arguments.volume, arguments.reading);
  const VolumeInfo& info = volume->info();
  OutputFile file(arguments.output);
  StreamOutput output(format == Format::stream ? &file.stream() : nullptr);
  Progress progress("slice", info.dims[2]);
  ExtractionOptions options = extraction_options(info, arguments.reading, progress);
  options.normals = format == Format::stream && arguments.normals == Normals::gradient;
  StreamHeader header = stream_header(info, options);
  header.scan = arguments.scan;
  Surfaces surfaces(info, arguments);
  const bool tells_slices = format == Format::stream && arguments.wire == Wire::slices;
  StreamOutput no_output(nullptr);
  surfaces.start(header.label(), (tells_slices ? no_output : output).byte_output());
  SliceWriter slices;
  if (tells_slices) {
    slices.start(surfaces.header_of_all(header), {arguments.key_slices}, output.byte_output());
    options.slices = &slices.encoder();
  }
  const std::vector<Extraction> extractions = extract(*volume, options, surfaces.requests());
  if (format != Format::stream) {
    Surface& surface = surfaces[0].builder.surface();
    surface.spacing_mm = info.spacing_mm;
    write_surface(
        surface, format, arguments.conforming,
        [&](Mesh& mesh) { add_normals(arguments, surface, mesh); }, file);
  }
  file.commit();
  if (arguments.quiet) return exit_ok;
  std::ostream& out = arguments.output == "-" ? std::cerr : std::cout;
  for (std::size_t i = 0; i < surfaces.count(); ++i) {
    if (surfaces.count() > 1)
      out << "channel " << i << ", at " << arguments.reading.isos[i] << '\n';
    write_table(extractions[i], count(surfaces[i].builder.surface()),
                tells_slices ? output.bytes() : surfaces[i].encoder.bytes(), out);
  }
  require_written(out);
  return exit_ok;
}

// The surfaces of a link by scan, channel and threshold.
std::vector<std::string> list_of_surfaces(const StreamReader& reader) {
  std::vector<std::string> list;
  for (const StreamHeader& header : reader.headers())
    for (std::uint32_t surface = 0; surface < header.surfaces(); ++surface)
      list.push_back("scan " + std::to_string(header.scan) + " channel " +
                     std::to_string(header.channel + surface) + " (threshold " +
                     std::to_string(header.threshold_of(surface)) + ")");
  return list;
}

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& item : list) text += (text.empty() ? "" : ", ") + item;
  return text;
}

// Reads the named stream; "-" is standard input.
void read_file(const std::string& path, StreamReader& reader) {
  std::ifstream file;
  if (path != "-") {
    if (!std::filesystem::is_directory(path)) file.open(path, std::ios::binary);
    if (!file.is_open())
      throw std::runtime_error(path + ": cannot be read: check the name and its permissions");
  }
  Progress progress("bytes", 0);
  try {
    reader.read(path == "-" ? std::cin : file,
                [&progress](std::uint64_t bytes) { progress.show(bytes); });
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (reader.report().has_header) return;
  if (!reader.headers().empty())
    throw std::runtime_error(path + ": no such surface: it has " +
                             joined(list_of_surfaces(reader)));
  throw std::runtime_error(path + ": no header of a discmc stream in " +
                           std::to_string(reader.report().bytes) + " bytes: is this a .dmc file?");
}

// Where there are several surfaces and none was asked for, the others are worth a word.
void note_others(const std::string& path, const StreamChoice& choice, const StreamReader& reader) {
  const std::vector<std::string> surfaces = list_of_surfaces(reader);
  if (surfaces.size() < 2 || !choice.is_any()) return;
  std::cerr << "discmc: " << path << ": this is scan " << reader.header().scan << " channel "
            << int{reader.channel()} << " of " << joined(surfaces)
            << ": choose with --scan N and --channel N\n";
}

struct DecodedStream {
  StreamHeader header;
  std::uint8_t channel;
  std::vector<StreamHeader> streams;  // all of the link
  StreamReport report;
  Surface surface;
  std::vector<std::string> records;  // the user's own, in words
};

// Notes the application records of a stream, and passes on what it is given.
struct RecordNotes {
  GrowingJoiner& to;
  std::vector<std::string> records{};
  Answer take(const Event& event) {
    if (event.kind == Event::Kind::application) records.push_back(text(*event.application));
    return to.take(event);
  }
};

DecodedStream decode_surface(const std::string& path, const StreamChoice& choice) {
  SurfaceBuilder builder;
  GrowingJoiner joiner(sink_to(builder));
  RecordNotes notes{joiner};
  StreamReader reader(sink_to(notes), choice);
  read_file(path, reader);
  note_others(path, choice, reader);
  joiner.finish();
  builder.surface().spacing_mm = spacing_mm(reader.header());
  StreamReport report = reader.report();
  report.lost_pieces += builder.incomplete_regions();
  return {reader.header(),
          reader.channel(),
          reader.headers(),
          report,
          std::move(builder.surface()),
          std::move(notes.records)};
}

// What is missing is said, and told by the exit code, but what is there is used.
int completeness(const std::string& path, const StreamReport& report) {
  if (report.is_complete()) return exit_ok;
  if (report.is_mixed)
    std::cerr << "discmc: " << path
              << ": two scans of one number are mixed in it: give every scan a number of its own\n";
  std::cerr << "discmc: " << path << ": the stream is incomplete: " << report.lost_packets
            << " packets and " << (report.holds_slices ? report.lost_rows : report.lost_pieces)
            << (report.holds_slices ? " rows" : " regions or fragments") << " are missing"
            << (report.has_trailer ? "" : ", and its end") << '\n';
  return exit_incomplete;
}

// A stream from a stream: what was whole, or is now that it is joined, packed anew.
class Recoder {
 public:
  explicit Recoder(const ByteOutput& output) : output_(output) {}
  Answer take(const Event& event) {
    if (event.kind == Event::Kind::start) {
      require(encoder_.start(event.header->label(), output_));
      encoder_.take(event);
      for (const Event& early : early_) encoder_.take(early);  // a file takes all
      is_started_ = true;
    } else if (is_started_) {
      encoder_.take(event);
    } else if (event.kind != Event::Kind::application) {  // what that points to will be gone
      early_.push_back(event);  // its first header is lost: wait for the next
    }
    return Answer::taken;
  }
  void flush() {
    if (is_started_ && !encoder_.flush()) throw std::runtime_error("the output takes no more");
  }

 private:
  ByteOutput output_;
  NormalEncoder encoder_;
  std::vector<Event> early_;  // before any header
  bool is_started_ = false;
};

// Opens the volume that a stream was made of. A headerless one has the stream's spacing.
std::unique_ptr<VolumeReader> open_volume_of(const StreamHeader& header,
                                             const StreamArguments& arguments) {
  std::optional<RawLayout> layout = raw_layout(arguments.layout);
  if (layout) layout->spacing_mm = spacing_mm(header);
  auto volume = open_volume(arguments.volume, layout);
  try {
    require_same_volume(volume->info(), header);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(arguments.volume + ": " + error.what());
  }
  return volume;
}

void add_normals(const StreamArguments& arguments, const DecodedStream& decoded, Mesh& mesh) {
  if (arguments.normals == Normals::none) return;
  set_polygon_normals(decoded.surface, mesh);
  if (arguments.normals == Normals::surface || mesh.vertices_mm.empty()) return;
  if (!arguments.volume.empty())
    add_gradient_normals(*open_volume_of(decoded.header, arguments), mesh);
  else if (!decoded.surface.normals.empty())
    set_told_normals(decoded.surface, mesh);
  else
    throw std::invalid_argument(arguments.stream +
                                ": the stream holds no normals: name the volume that it was made "
                                "of with --volume FILE, or take --normals surface");
}

int run_decode(const StreamArguments& arguments) {
  const Format format = format_of(arguments.output);
  OutputFile file(arguments.output);
  StreamReport report;
  if (format == Format::stream) {
    StreamOutput output(&file.stream());
    Recoder recoder(output.byte_output());
    GrowingJoiner joiner(sink_to(recoder));
    StreamReader reader(sink_to(joiner), arguments.choice);
    read_file(arguments.stream, reader);
    note_others(arguments.stream, arguments.choice, reader);
    joiner.finish();
    recoder.flush();
    report = reader.report();
  } else {
    const DecodedStream decoded = decode_surface(arguments.stream, arguments.choice);
    write_surface(
        decoded.surface, format, arguments.conforming,
        [&](Mesh& mesh) { add_normals(arguments, decoded, mesh); }, file);
    report = decoded.report;
  }
  file.commit();
  return completeness(arguments.stream, report);
}

int run_info(const StreamArguments& arguments) {
  const DecodedStream decoded = decode_surface(arguments.stream, arguments.choice);
  write_info(decoded.header, decoded.channel, decoded.streams, decoded.report,
             count(decoded.surface), std::cout);
  for (const std::string& record : decoded.records) std::cout << "record " << record << '\n';
  require_written(std::cout);
  return completeness(arguments.stream, decoded.report);
}

// A mesh that can be shaded smoothly if that is asked, then with the normals that the surface has.
Mesh mesh_to_draw(const Surface& surface, bool smooth) {
  Mesh mesh = build_mesh(surface, {true, smooth ? Faces::triangles : Faces::polygons});
  if (!smooth || surface.normals.empty()) return mesh;
  mesh.normals = surface_normals(mesh);
  set_told_normals(surface, mesh);
  return mesh;
}

Mesh volume_to_draw(const RenderArguments& arguments) {
  const auto volume = open_noted_volume(arguments.input, arguments.reading);
  Progress progress("slice", volume->info().dims[2]);
  auto options = extraction_options(volume->info(), arguments.reading, progress);
  options.normals = arguments.smooth;
  if (arguments.classic) return classic_mesh(*volume, options);
  SurfaceBuilder builder;
  GrowingJoiner joiner(sink_to(builder));
  extract(*volume, options, sink_to(joiner));
  builder.surface().spacing_mm = volume->info().spacing_mm;
  return mesh_to_draw(builder.surface(), arguments.smooth);
}

PictureOptions picture_options(const RenderArguments& arguments) {
  PictureOptions options;
  options.width = arguments.size[0];
  options.height = arguments.size[1];
  options.from = {arguments.view[0], arguments.view[1], arguments.view[2]};
  options.zoom = arguments.zoom;
  if (!arguments.at.empty()) options.at = {arguments.at[0], arguments.at[1], arguments.at[2]};
  options.shading = arguments.smooth ? Shading::smooth : Shading::flat;
  options.outlines = arguments.outlines;
  return options;
}

int run_render(const RenderArguments& arguments) {
  Mesh mesh;
  int code = exit_ok;
  if (arguments.kind == InputKind::mesh) {
    mesh = read_mesh(arguments.input);
    if (arguments.smooth) mesh = triangulated(mesh);
  } else if (arguments.kind == InputKind::volume) {
    mesh = volume_to_draw(arguments);
  } else {
    const DecodedStream decoded = decode_surface(arguments.input, arguments.choice);
    mesh = mesh_to_draw(decoded.surface, arguments.smooth);
    code = completeness(arguments.input, decoded.report);
  }
  if (arguments.smooth && mesh.normals.empty()) mesh.normals = surface_normals(mesh);
  write_picture(mesh, picture_options(arguments), arguments.output);
  return code;
}

int run(int argc, char** argv) {
  CLI::App app{
      "Surfaces of scanned volumes by Discretized Marching Cubes, merged while they stream",
      "discmc"};
  app.require_subcommand(1);
  app.set_version_flag("--version", DISCMC_VERSION);
  app.footer("Exit codes: 0 done, 1 failed, 2 wrong usage, 3 done but the stream was incomplete.");
  ExtractArguments extract_arguments;
  StreamArguments stream_arguments;
  RenderArguments render_arguments;
  add_extract(app, extract_arguments);
  add_stream_commands(app, stream_arguments);
  add_render(app, render_arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  if (app.got_subcommand("extract")) return run_extract(extract_arguments);
  if (app.got_subcommand("decode")) return run_decode(stream_arguments);
  if (app.got_subcommand("info")) return run_info(stream_arguments);
  return run_render(render_arguments);
}

}  // namespace
}  // namespace discmc::host

int main(int argc, char** argv) {
  try {
    return discmc::host::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr
        << "discmc: the memory of this computer is not enough: take a smaller volume or stream\n";
    return discmc::host::exit_failure;
  } catch (const std::exception& error) {
    std::cerr << "discmc: " << error.what() << '\n';
    return discmc::host::exit_failure;
  }
}
