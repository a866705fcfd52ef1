// discmc decode: converts a stream to a mesh, or to another stream.
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "commands.hpp"
#include "extraction/extraction.hpp"
#include "files/output_file.hpp"
#include "mesh_files/file_format.hpp"
#include "mesh_files/mesh_files.hpp"
#include "mesh_output.hpp"
#include "meshes/surface_normals.hpp"
#include "meshes/vertex_normals.hpp"
#include "require.hpp"
#include "samples/spacing.hpp"
#include "stream_input.hpp"
#include "streams/stream_output.hpp"
#include "surface/growing_joiner.hpp"
#include "volume_input.hpp"
#include "volumes/volume_offset.hpp"

namespace discmc::command {
namespace {

// Re-encodes a stream: its whole regions, and the regions joined from fragments.
class Recoder {
 public:
  explicit Recoder(const ByteOutput& output) : output_(output) {}
  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) {
      encoder_.encode_normals();
      require(encoder_.start(event.header->label(), output_));
      encoder_.accept(event);
      for (const Event& early : early_) encoder_.accept(early);  // a file accepts all
      is_started_ = true;
    } else if (is_started_) {
      encoder_.accept(event);
    } else if (event.kind !=
               Event::Kind::application) {  // its bytes are valid during the call only
      early_.push_back(event);              // its first header is lost: wait for the next
    }
    return SinkResult::accepted;
  }
  void flush() {
    (void)encoder_.flush();  // a file accepts all; commit() reports a failed write
  }

 private:
  ByteOutput output_;
  Encoder encoder_;
  std::vector<Event> early_;  // before any header
  bool is_started_ = false;
};

// A part of the same extents may still have another place in the volume.
void require_same_part(const VolumeInfo& volume, const DecodedStream& decoded) {
  if (!volume.whole_dims || !decoded.placement) return;
  VolumeInfo stream_part = volume;
  stream_part.placement = decoded.placement;
  const double apart = offset_mm(volume, stream_part);
  if (apart == 0) return;
  std::ostringstream text;
  text << "the part of the volume lies " << apart
       << " mm from the part of the stream; give the --crop and --shrink that the stream was made "
          "with";
  throw std::invalid_argument(text.str());
}

// Opens the volume from which the stream was made. A headerless volume gets the spacing that the
// stream had before it was shrunk, unless the user gives another spacing.
std::unique_ptr<SliceReader> open_volume_of(const DecodedStream& decoded,
                                            const StreamArguments& arguments) {
  const StreamHeader& header = decoded.header;
  VolumeOptions options = arguments.options;
  if (options.layout && !options.spacing_mm) {
    options.spacing_mm = spacing_mm(header);
    for (double& spacing : *options.spacing_mm) spacing /= options.shrink;
  }
  // An offset of the values does not change the direction of their gradient.
  GradientVolume volume = open_for_gradient(arguments.volume, options, header.thresholds[0]);
  try {
    require_same_volume(volume.info, header);
    require_same_part(volume.info, decoded);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(arguments.volume + ": " + error.what());
  }
  return std::move(volume.reader);
}

void add_normals(const StreamArguments& arguments, const DecodedStream& decoded, FileMesh& mesh) {
  if (arguments.normals == Normals::none) return;
  if (arguments.surface == SurfaceKind::merged)
    set_polygon_normals(decoded.surface, mesh);
  else
    mesh.normals = surface_normals(mesh);
  if (arguments.normals == Normals::surface || mesh.vertices_mm.empty()) return;
  if (!arguments.volume.empty())
    add_gradient_normals(*open_volume_of(decoded, arguments), mesh);
  else if (!decoded.surface.normals.empty())
    set_stream_normals(decoded.surface, mesh);
  else
    throw std::invalid_argument(arguments.stream +
                                ": the stream holds no normals; name its volume with --volume "
                                "FILE, or give --normals surface");
}

}  // namespace

int run_decode(const StreamArguments& arguments) {
  const Format format = format_of(arguments.output);
  OutputFile file(arguments.output);
  StreamReport report;
  if (format == Format::stream) {
    StreamOutput output(&file.stream());
    Recoder recoder(output.byte_output());
    GrowingJoiner joiner(make_sink(recoder));
    StreamReader reader(make_sink(joiner), arguments.choice);
    read_file(arguments.stream, reader);
    note_others(arguments.stream, arguments.choice, reader);
    joiner.finish();
    recoder.flush();
    report = reader.report();
  } else {
    DecodedStream decoded = decode_surface(arguments.stream, arguments.choice);
    note_empty(arguments.stream, decoded);
    MeshingOptions meshing = arguments.mesh;
    const std::optional<Crossings> crossings =
        crossings_of(arguments.stream, decoded, arguments.surface, meshing.tolerance);
    if (crossings) meshing.crossings = &*crossings;
    keep_chosen(arguments.stream, arguments.components, decoded.surface);
    const auto placement = mesh_placement(arguments.stream, decoded.placement, arguments.space);
    if (format == Format::jsonl) {
      write_to(file, [&](std::ostream& out) { write_jsonl(decoded.surface, out); });
    } else {
      FileMesh mesh = triangulated(decoded.surface, meshing);
      note_left_out(arguments.stream, decoded.surface, mesh.left_out);
      add_normals(arguments, decoded, mesh);
      place_in_file(mesh, placement, arguments.size);
      note_rounding(arguments.output, mesh);
      write_to(file,
               [&](std::ostream& out) { write_mesh(mesh, format, out, arguments.mesh.jobs); });
    }
    report = decoded.report;
  }
  file.commit();
  return completeness(arguments.stream, report);
}

}  // namespace discmc::command
